// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include "runtime/scenario/shared_tables.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Lengths and masses of a Pioneer 3-DX that follow from the scenario's `[robots]`. Frame B: x forward, y
/// left, z up, origin on the floor under the middle of the axle.
struct BodyPlan {
  explicit BodyPlan(const runtime::RobotsTable& robots);

  dVector3 box_size{};     ///< of the hull, whose lower edge is above the floor
  dVector3 box_centre{};   ///< in B
  dVector3 mass_centre{};  ///< of the chassis, in B
  double wheel_radius = 0.0;
  double half_track = 0.0;
  double caster_x = 0.0;
  double caster_radius = 0.0;
  double chassis_mass = 0.0;
  double wheel_mass = 0.0;
  double wheel_inertia = 0.0;
  double motor_torque = 0.0;  ///< limit of each motor
};

/// One robot's bodies, joints and hull.
struct RobotBody {
  dBodyID chassis = nullptr;
  dBodyID left = nullptr;
  dBodyID right = nullptr;
  dJointID left_motor = nullptr;
  dJointID right_motor = nullptr;
  dGeomID hull = nullptr;
};

/// Builds a robot at the origin, heading east.
[[nodiscard]] RobotBody build_robot(dWorldID world, const BodyPlan& plan);

/// Adds contacts of the wheels and the caster with the floor, where they touch it.
void add_floor_contacts(dWorldID world, dJointGroupID contacts, const RobotBody& body, const BodyPlan& plan);

}  // namespace caravan::world
