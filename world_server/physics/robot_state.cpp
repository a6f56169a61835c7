// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/robot_state.hpp"

#include <algorithm>
#include <cmath>

#include "world_server/shapes/point.hpp"

namespace caravan::world {
namespace {

template <std::size_t kSize>
void copy(const dReal* from, std::array<double, kSize>& to) {
  std::copy_n(from, kSize, to.begin());
}

/// The direction of y of B.
std::array<double, 3> axle_of(const RobotState& state) {
  const auto& [w, x, y, z] = state.orientation;
  return {2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)};
}

double rate_about(const std::array<double, 3>& axle, dBodyID wheel, dBodyID chassis) {
  const dReal* a = dBodyGetAngularVel(wheel);
  const dReal* b = dBodyGetAngularVel(chassis);
  return axle[0] * (a[0] - b[0]) + axle[1] * (a[1] - b[1]) + axle[2] * (a[2] - b[2]);
}

void load_wheel(const RobotState& state, dBodyID chassis, dBodyID wheel, const std::array<double, 3>& hub,
                double rate) {
  dVector3 vector;
  dBodyGetRelPointPos(chassis, hub[0], hub[1], hub[2], vector);
  dBodySetPosition(wheel, vector[0], vector[1], vector[2]);
  dBodySetQuaternion(wheel, state.orientation.data());
  dBodyGetRelPointVel(chassis, hub[0], hub[1], hub[2], vector);
  dBodySetLinearVel(wheel, vector[0], vector[1], vector[2]);
  const std::array<double, 3> axle = axle_of(state);
  dBodySetAngularVel(wheel, state.angular_velocity[0] + rate * axle[0],
                     state.angular_velocity[1] + rate * axle[1], state.angular_velocity[2] + rate * axle[2]);
}

void load_motor(dJointID motor, double target, double torque) {
  dJointSetHingeParam(motor, dParamVel, target);
  dJointSetHingeParam(motor, dParamFMax, torque);
}

}  // namespace

void stand(RobotState& state, const BodyPlan& plan, const Pose& pose) {
  const double cosine = std::cos(pose.yaw_rad);
  const double sine = std::sin(pose.yaw_rad);
  state.position = {pose.x_m + cosine * plan.mass_centre[0], pose.y_m + sine * plan.mass_centre[0],
                    plan.mass_centre[2]};
  state.orientation = {std::cos(0.5 * pose.yaw_rad), 0.0, 0.0, std::sin(0.5 * pose.yaw_rad)};
  state.linear_velocity = {};
  state.angular_velocity = {};
  state.left_rate = 0.0;
  state.right_rate = 0.0;
}

Pose pose_of(const RobotState& state, const BodyPlan& plan) {
  const auto& [w, x, y, z] = state.orientation;
  const double ahead_x = 1.0 - 2.0 * (y * y + z * z);
  const double ahead_y = 2.0 * (x * y + w * z);
  const double up_x = 2.0 * (x * z + w * y);
  const double up_y = 2.0 * (y * z - w * x);
  return {state.position[0] - plan.mass_centre[0] * ahead_x - plan.mass_centre[2] * up_x,
          state.position[1] - plan.mass_centre[0] * ahead_y - plan.mass_centre[2] * up_y,
          std::atan2(ahead_y, ahead_x)};
}

double lift_of(const RobotState& state, const BodyPlan& plan) {
  const auto& [w, x, y, z] = state.orientation;
  return state.position[2] - plan.mass_centre[0] * 2.0 * (x * z - w * y) -
         plan.mass_centre[2] * uprightness_of(state);
}

double uprightness_of(const RobotState& state) {
  return 1.0 -
         2.0 * (state.orientation[1] * state.orientation[1] + state.orientation[2] * state.orientation[2]);
}

void bend(RobotState& state, const std::array<double, 3>& from, double seconds) {
  const double half = 0.5 * seconds * state.angular_velocity[2];
  const Point to = placed({state.position[0] - from[0], state.position[1] - from[1]}, {from[0], from[1]},
                          std::cos(half), std::sin(half));
  state.position[0] = to.x;
  state.position[1] = to.y;
}

void load(const RobotState& state, const RobotBody& body, const BodyPlan& plan) {
  dBodySetPosition(body.chassis, state.position[0], state.position[1], state.position[2]);
  dBodySetQuaternion(body.chassis, state.orientation.data());
  dBodySetLinearVel(body.chassis, state.linear_velocity[0], state.linear_velocity[1],
                    state.linear_velocity[2]);
  dBodySetAngularVel(body.chassis, state.angular_velocity[0], state.angular_velocity[1],
                     state.angular_velocity[2]);
  dBodySetForce(body.chassis, state.force[0], state.force[1], state.force[2]);
  dBodySetTorque(body.chassis, state.torque[0], state.torque[1], state.torque[2]);
  const double x = -plan.mass_centre[0];
  const double z = plan.wheel_radius - plan.mass_centre[2];
  load_wheel(state, body.chassis, body.left, {x, plan.half_track, z}, state.left_rate);
  load_wheel(state, body.chassis, body.right, {x, -plan.half_track, z}, state.right_rate);
  load_motor(body.left_motor, state.left_target, state.motor_torque);
  load_motor(body.right_motor, state.right_target, state.motor_torque);
}

void store(const RobotBody& body, RobotState& state) {
  // A step solves for velocities at its start pose, so the axle is that of the previous orientation.
  const std::array<double, 3> axle = axle_of(state);
  state.left_rate = rate_about(axle, body.left, body.chassis);
  state.right_rate = rate_about(axle, body.right, body.chassis);
  copy(dBodyGetPosition(body.chassis), state.position);
  copy(dBodyGetQuaternion(body.chassis), state.orientation);
  copy(dBodyGetLinearVel(body.chassis), state.linear_velocity);
  copy(dBodyGetAngularVel(body.chassis), state.angular_velocity);
  store_forces(body, state);
}

void store_forces(const RobotBody& body, RobotState& state) {
  copy(dBodyGetForce(body.chassis), state.force);
  copy(dBodyGetTorque(body.chassis), state.torque);
}

}  // namespace caravan::world
