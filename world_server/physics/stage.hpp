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
/// What happens on it depends only on the states that entered, not on who was there before. So a fleet of any
/// size is stepped in memory that stays in the processor's cache.
class Stage {
 public:
  Stage(const WorldConfig& config, const Statics& statics, std::size_t robots);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void enter(std::size_t place, const RobotState& state) { load(state, robots_[place], plan_); }
  void leave(std::size_t place, RobotState& state) const { store(robots_[place], state); }
  /// Only the forces that the robot at `place` is to feel in its next step.
  void leave_forces(std::size_t place, RobotState& state) const { store_forces(robots_[place], state); }

  /// Lets the robot at `place`, which entered with `state`, rest on the floor and feel its push in the next
  /// step.
  void stand(std::size_t place, const RobotState& state);
  /// Lets it bump, in the next step, into what is static around its base. @return does it touch any of it?
  bool bump(std::size_t place, Point base);
  /// Do the two robots here touch each other? contacts() tells where, until the next call.
  [[nodiscard]] bool meet();
  [[nodiscard]] std::span<const dContactGeom> contacts() const { return bumps_.all(); }
  /// In the next step. `contacts` are those of a meet() of the same two.
  void hold_apart(std::span<const dContactGeom> contacts);
  /// By forces with which they leave. `contacts` are those of a meet() of the same two.
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
