// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Two bodies that touched. Robots are numbered from 1.
struct Touch {
  std::uint32_t robot = 0;
  std::uint32_t other = 0;  ///< a higher robot, or 0: something static. The floor does not count.
  auto operator<=>(const Touch&) const = default;
};

/// Deviation of a body from standing upright on the floor.
struct Stance {
  double tilt_rad = 0.0;  ///< tilt of its vertical axis
  double lift_m = 0.0;    ///< height of its base above the floor; negative: below it
};

/// The rigid bodies of a world: robots on two driven wheels and a caster, and everything static.
///
/// Deterministic: equal configurations, starts and commands give equal bits on one machine type, whatever
/// else runs in the process. Robots are indexed from 0 here.
class Dynamics {
 public:
  /// @throws PhysicsError when ODE refuses the body
  Dynamics(const WorldConfig& config, std::span<const Pose> starts);
  ~Dynamics();
  Dynamics(Dynamics&&) noexcept;
  Dynamics& operator=(Dynamics&&) noexcept;

  /// Sets the rim speeds that the wheel motors hold, as far as their torque allows.
  void drive(std::size_t robot, double left_mps, double right_mps);
  /// Disconnects the motors from the wheels, or connects them again.
  void free_wheels(std::size_t robot, bool free);
  /// Applies a force at the centre of mass along the heading, for the whole next step.
  void push(std::size_t robot, double force_n);

  /// Places a robot at a pose, at rest. Its wheel angles do not change.
  /// @pre the place is free
  void place(std::size_t robot, const Pose& pose);
  /// Removes a robot: nothing touches it, and its pose is NaN, until it is placed.
  void remove(std::size_t robot);

  /// One step of config.step_s. @throws PhysicsError naming the robots that ODE cannot step
  void advance();

  [[nodiscard]] std::span<const Pose> poses() const;
  [[nodiscard]] double left_wheel_rad(std::size_t robot) const;
  [[nodiscard]] double right_wheel_rad(std::size_t robot) const;
  [[nodiscard]] Stance stance(std::size_t robot) const;
  /// Warning of ODE's solver in the last step, with the robots' numbers; empty: none. The solver has
  /// continued with an approximate result, which is accurate where bodies lie flat against each other, and a
  /// guess elsewhere.
  [[nodiscard]] const std::string& complaint() const;
  /// Touches during the last step: sorted, each pair once.
  [[nodiscard]] std::span<const Touch> touches() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::world
