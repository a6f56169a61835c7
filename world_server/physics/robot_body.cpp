// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/robot_body.hpp"

#include <cmath>

namespace caravan::world {
namespace {

// Fractions of the whole, from the Pioneer's data (9.01 kg with wheels of 1.04 kg, caster 0.205 m and
// centre of mass 0.06 m behind an axle that the body reaches 0.285 m behind).
constexpr double kWheelShare = 1.04 / 9.0;
constexpr double kCasterBehind = 0.205 / 0.285;
constexpr double kMassBehind = 0.06 / 0.285;
constexpr double kCasterRadius = 0.0375 / 0.0975;
constexpr double kHullClearance = 0.5;  // of the wheel radius

// A disc has 0.5 m r^2 and would make 9 kg react like 10; the reference motion (9 N give 1.0 m/s2) is that of
// 9 kg alone, so a wheel's mass is at its hub.
constexpr double kWheelInertia = 0.02;

// What the two motors can achieve together: 4.1 m/s2 for the whole robot. Below the 4.5 m/s2 at which braking
// would lift the caster, and below the grip of the tyres.
constexpr double kMotorAcceleration = 4.1;

constexpr double kTyreFriction = 1.0;
// m/s per N, sideways. Both tyres act on the same line, so only their sum is determined; without this
// the solver's matrix is singular.
constexpr double kTyreCreep = 1e-5;

void add_contact(dWorldID world, dJointGroupID contacts, dBodyID body, const dReal* centre, double radius,
                 const dReal* rolling) {
  const double depth = radius - centre[2];
  if (depth < 0.0) return;
  dContact contact{};
  contact.geom.pos[0] = centre[0];
  contact.geom.pos[1] = centre[1];
  contact.geom.pos[2] = centre[2] - radius;
  contact.geom.normal[2] = 1.0;
  contact.geom.depth = depth;
  if (rolling != nullptr) {
    contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactSlip2;
    contact.surface.mu = kTyreFriction;
    contact.surface.slip2 = kTyreCreep;
    contact.fdir1[0] = rolling[0];
    contact.fdir1[1] = rolling[1];
  }
  dJointAttach(dJointCreateContact(world, contacts, &contact), body, nullptr);
}

dBodyID build_wheel(dWorldID world, const BodyPlan& plan) {
  dMass mass;
  dMassSetParameters(&mass, plan.wheel_mass, 0, 0, 0, plan.wheel_inertia, plan.wheel_inertia,
                     plan.wheel_inertia, 0, 0, 0);
  const dBodyID wheel = dBodyCreate(world);
  dBodySetMass(wheel, &mass);
  dBodySetGyroscopicMode(wheel, 0);
  return wheel;
}

dJointID build_motor(dWorldID world, const BodyPlan& plan, dBodyID wheel, dBodyID chassis) {
  const dReal* at = dBodyGetPosition(wheel);
  const dJointID motor = dJointCreateHinge(world, nullptr);
  dJointAttach(motor, wheel, chassis);
  dJointSetHingeAnchor(motor, at[0], at[1], at[2]);
  dJointSetHingeAxis(motor, 0.0, 1.0, 0.0);  // y of B: a positive rate rolls forward
  dJointSetHingeParam(motor, dParamVel, 0.0);
  dJointSetHingeParam(motor, dParamFMax, plan.motor_torque);
  return motor;
}

}  // namespace

BodyPlan::BodyPlan(const runtime::RobotsTable& robots)
    : wheel_radius{robots.wheel_radius_m}, half_track{0.5 * robots.track_m} {
  const double behind = robots.body_length_m - robots.body_ahead_m;
  const double clearance = kHullClearance * wheel_radius;
  box_size[0] = robots.body_length_m;
  box_size[1] = robots.body_width_m;
  box_size[2] = robots.body_height_m - clearance;
  box_centre[0] = robots.body_ahead_m - 0.5 * robots.body_length_m;
  box_centre[2] = clearance + 0.5 * box_size[2];
  mass_centre[0] = -kMassBehind * behind;
  mass_centre[2] = wheel_radius;
  caster_x = -kCasterBehind * behind;
  caster_radius = kCasterRadius * wheel_radius;
  wheel_mass = kWheelShare * robots.mass_kg;
  chassis_mass = robots.mass_kg - 2.0 * wheel_mass;
  wheel_inertia = kWheelInertia * wheel_mass * wheel_radius * wheel_radius;
  motor_torque = 0.5 * kMotorAcceleration * robots.mass_kg * wheel_radius;
}

RobotBody build_robot(dWorldID world, const BodyPlan& plan) {
  RobotBody body;
  dMass mass;
  dMassSetBoxTotal(&mass, plan.chassis_mass, plan.box_size[0], plan.box_size[1], plan.box_size[2]);
  body.chassis = dBodyCreate(world);
  dBodySetMass(body.chassis, &mass);
  dBodySetFiniteRotationMode(body.chassis, 1);
  dBodySetPosition(body.chassis, plan.mass_centre[0], plan.mass_centre[1], plan.mass_centre[2]);
  body.hull = dCreateBox(nullptr, plan.box_size[0], plan.box_size[1], plan.box_size[2]);
  dGeomSetBody(body.hull, body.chassis);
  dGeomSetOffsetPosition(body.hull, plan.box_centre[0] - plan.mass_centre[0], 0.0,
                         plan.box_centre[2] - plan.mass_centre[2]);

  body.left = build_wheel(world, plan);
  body.right = build_wheel(world, plan);
  dBodySetPosition(body.left, 0.0, plan.half_track, plan.wheel_radius);
  dBodySetPosition(body.right, 0.0, -plan.half_track, plan.wheel_radius);
  body.left_motor = build_motor(world, plan, body.left, body.chassis);
  body.right_motor = build_motor(world, plan, body.right, body.chassis);
  return body;
}

void add_floor_contacts(dWorldID world, dJointGroupID contacts, const RobotBody& body, const BodyPlan& plan) {
  const dReal* turned = dBodyGetRotation(body.chassis);
  const double flat = std::hypot(turned[0], turned[4]);
  const dVector3 rolling{turned[0] / flat, turned[4] / flat, 0.0};
  add_contact(world, contacts, body.left, dBodyGetPosition(body.left), plan.wheel_radius, rolling);
  add_contact(world, contacts, body.right, dBodyGetPosition(body.right), plan.wheel_radius, rolling);
  dVector3 caster;
  dBodyGetRelPointPos(body.chassis, plan.caster_x - plan.mass_centre[0], 0.0,
                      plan.caster_radius - plan.mass_centre[2], caster);
  add_contact(world, contacts, body.chassis, caster, plan.caster_radius, nullptr);
}

}  // namespace caravan::world
