// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "world_server/physics/robot_body.hpp"

namespace caravan::world {

/// Everything that determines a robot's motion in the next physics step, except what it touches. Frame W, SI
/// units. The wheels are where the axle holds them.
struct RobotState {
  std::array<double, 3> position{};          ///< of the chassis' centre of mass
  std::array<double, 4> orientation{};       ///< of the chassis; unit quaternion, w first
  std::array<double, 3> linear_velocity{};   ///< of the chassis' centre of mass
  std::array<double, 3> angular_velocity{};  ///< of the chassis
  double left_rate = 0.0;                    ///< of the wheels relative to the chassis, rad/s
  double right_rate = 0.0;
  double left_target = 0.0;  ///< rate that the motor holds
  double right_target = 0.0;
  double motor_torque = 0.0;      ///< N m, limit of each motor
  double push_n = 0.0;            ///< at the centre of mass, along the heading
  std::array<double, 3> force{};  ///< on the chassis, for one physics step
  std::array<double, 3> torque{};
  double left_rad = 0.0;  ///< angle that the wheel has turned
  double right_rad = 0.0;
};

/// Sets a robot on its wheels at `pose`, at rest.
void stand(RobotState& state, const BodyPlan& plan, const Pose& pose);

/// Pose of its base.
[[nodiscard]] Pose pose_of(const RobotState& state, const BodyPlan& plan);
/// Height of its base above the floor.
[[nodiscard]] double lift_of(const RobotState& state, const BodyPlan& plan);
/// Cosine between its vertical axis and the world's.
[[nodiscard]] double uprightness_of(const RobotState& state);
/// Whether the edge of its hull stays off the floor.
[[nodiscard]] inline bool is_upright(const RobotState& state) { return uprightness_of(state) >= 0.995; }

/// Bends the straight line from `from` to the state's position into the arc of a robot that turned at a
/// constant rate.
void bend(RobotState& state, const std::array<double, 3>& from, double seconds);

/// Sets ODE's bodies to `state`, the wheels exactly on their axle.
void load(const RobotState& state, const RobotBody& body, const BodyPlan& plan);
/// Reads the state of ODE's bodies; values that they do not have (targets, wheel angles, push) stay.
void store(const RobotBody& body, RobotState& state);
/// Reads only force and torque.
void store_forces(const RobotBody& body, RobotState& state);

}  // namespace caravan::world
