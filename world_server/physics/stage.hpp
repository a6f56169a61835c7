// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "world_server/physics/bumps.hpp"
#include "world_server/physics/ode_session.hpp"
#include "world_server/physics/robot_body.hpp"
#include "world_server/physics/robot_state.hpp"
#include "world_server/physics/statics.hpp"

namespace caravan::world {

/// An ODE world that holds one or two robots of a fleet while they take a physics step.
///
/// The result depends only on the states that entered, not on earlier robots. A fleet of any size is
/// therefore stepped in memory that stays in the processor's cache.
class Stage {
 public:
  Stage(const WorldConfig& config, const Statics& statics, std::size_t robots);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void enter(std::size_t place, const RobotState& state) { load(state, robots_[place], plan_); }
  void leave(std::size_t place, RobotState& state) const { store(robots_[place], state); }
  /// Stores only the forces on the robot at `place` in its next step.
  void leave_forces(std::size_t place, RobotState& state) const { store_forces(robots_[place], state); }

  /// Prepares the next step: the robot at `place`, which entered with `state`, rests on the floor, and its
  /// push is applied.
  void stand(std::size_t place, const RobotState& state);
  /// Adds its contacts with static things around its base for the next step. @return whether it touches any
  bool bump(std::size_t place, Point base);
  /// Whether the two robots touch each other. contacts() has the places, until the next call.
  [[nodiscard]] bool meet();
  [[nodiscard]] std::span<const dContactGeom> contacts() const { return bumps_.all(); }
  /// Separates the two in the next step with hard contacts. `contacts` are those of a meet() of the same two.
  void hold_apart(std::span<const dContactGeom> contacts);
  /// Separates the two with forces, which leave() stores. `contacts` are those of a meet() of the same two.
  void push_apart(std::span<const dContactGeom> contacts);
  /// One physics step.
  void step(double seconds) { ode_.step(seconds); }

 private:
  void collide_with_floor(std::size_t place);

  OdeSession ode_;
  BodyPlan plan_;
  const Statics& statics_;
  double hull_radius_;
  Spring spring_;
  Bumps bumps_;
  std::vector<RobotBody> robots_;
};

}  // namespace caravan::world
