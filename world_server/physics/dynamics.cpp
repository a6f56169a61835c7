// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "world_server/physics/ode_session.hpp"
#include "world_server/physics/robot_body.hpp"
#include "world_server/physics/statics.hpp"
#include "world_server/shapes/neighbours.hpp"

namespace caravan::world {
namespace {

constexpr double kGravity = 9.81;
// N, the most that one contact point of a hull holds along the surface. A fixed force, not a share of the
// pressure: with the latter the solver meets contacts that neither press nor hold, and gives up on them.
constexpr double kHullGrip = 2.0;
// m/s per N. Hulls that lie flat against each other have more contacts than their forces are determined by;
// with none of this the solver's matrix is singular.
constexpr double kSoftness = 1e-4;
// Share of an error in the joints' and contacts' positions that one physics step takes back. A wheel that
// moves along its tangent leaves its circle a little in each step: what is not taken back widens the track.
constexpr double kJointCorrection = 0.8;
constexpr double kContactCorrection = 0.2;
constexpr double kSamePlace = 0.005;
constexpr double kSameWay = 0.95;
constexpr int kMaxContacts = 8;  // of one pair
// Keeps resting contacts closed, so that wheels neither bounce nor rattle.
constexpr double kSurfaceLayer = 0.0005;
// A body that got into another is pushed out no faster than this, so that nothing is shot away.
constexpr double kMaxPushOut = 1.0;

/// All hulls are upright, so contacts that lie above each other say the same. They are taken as one at the
/// height of the centre of mass: a knock turns a robot but does not tip it, and the solver, whose time grows
/// with the cube of the contacts, has half as many and none that depend on each other.
void merge_into(std::vector<dContactGeom>& bumps, dContactGeom geom, double height) {
  const double flat = std::hypot(geom.normal[0], geom.normal[1]);
  if (flat < 0.5) return;  // one hull on top of another: no case of an upright world
  geom.normal[0] /= flat;
  geom.normal[1] /= flat;
  geom.normal[2] = 0.0;
  geom.pos[2] = height;
  for (dContactGeom& bump : bumps) {
    if (std::hypot(bump.pos[0] - geom.pos[0], bump.pos[1] - geom.pos[1]) > kSamePlace) continue;
    if (bump.normal[0] * geom.normal[0] + bump.normal[1] * geom.normal[1] < kSameWay) continue;
    bump.depth = std::max(bump.depth, geom.depth);
    return;
  }
  bumps.push_back(geom);
}

}  // namespace

struct Dynamics::Impl {
  Impl(const WorldConfig& config, std::span<const Pose> starts)
      : plan{config.robots},
        statics{config, body_radius_m(config.robots) + reach_margin(config)},
        hull_radius{body_radius_m(config.robots)},
        margin{reach_margin(config)},
        substeps{config.substeps},
        substep_s{config.step_s / config.substeps} {
    ode.prepare_thread();
    dRandSetSeed(1);
    for (const Pose& start : starts) robots.push_back(build_robot(ode.world(), plan, start));
    poses.assign(starts.begin(), starts.end());
    left_rad.assign(starts.size(), 0.0);
    right_rad.assign(starts.size(), 0.0);
    push_n.assign(starts.size(), 0.0);
    dWorldSetERP(ode.world(), kJointCorrection);
    dWorldSetGravity(ode.world(), 0.0, 0.0, -kGravity);
    dWorldSetContactSurfaceLayer(ode.world(), kSurfaceLayer);
    dWorldSetContactMaxCorrectingVel(ode.world(), kMaxPushOut);
  }
  ~Impl() {
    for (const RobotBody& robot : robots) dGeomDestroy(robot.hull);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// How far a robot may come in one step, twice over.
  static double reach_margin(const WorldConfig& config) {
    return 2.0 * config.robots.wheel_limit_mps * config.step_s + 0.02;
  }

  void advance() {
    ode.prepare_thread();
    touches.clear();
    find_pairs();
    for (std::uint32_t i = 0; i < substeps; ++i) substep();
    for (std::size_t i = 0; i < robots.size(); ++i) poses[i] = pose_of(robots[i], plan);
    std::fill(push_n.begin(), push_n.end(), 0.0);
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  }

  /// Robots that could touch in this step, each pair once, sorted.
  void find_pairs() {
    places.clear();
    for (const Pose& pose : poses) places.push_back({pose.x_m, pose.y_m});
    neighbours.rebuild(places, 2.0 * (hull_radius + margin));
    pairs.clear();
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      neighbours.near(places[i], found);
      for (const std::uint32_t k : found) {
        if (k > i) pairs.push_back({i, k});
      }
    }
  }

  void substep() {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const RobotBody& robot = robots[i];
      add_floor_contacts(ode.world(), ode.contacts(), robot, plan);
      if (push_n[i] != 0.0) dBodyAddRelForce(robot.chassis, push_n[i], 0.0, 0.0);
      const Pose now = pose_of(robot, plan);
      places[i] = {now.x_m, now.y_m};
      statics.near(places[i], hull_radius, [&](dGeomID thing) { collide(i, robot.hull, thing, 0); });
      add_bumps();
      if (leans(robot)) collide_with_floor(robot);
    }
    for (const auto& [a, b] : pairs) {
      const Point apart = places[b] - places[a];
      if (dot(apart, apart) > 4.0 * hull_radius * hull_radius) continue;
      collide(a, robots[a].hull, robots[b].hull, b + 1);
      add_bumps();
    }
    dWorldStep(ode.world(), substep_s);
    dJointGroupEmpty(ode.contacts());
    for (std::size_t i = 0; i < robots.size(); ++i) {
      left_rad[i] += substep_s * dJointGetHingeAngleRate(robots[i].left_motor);
      right_rad[i] += substep_s * dJointGetHingeAngleRate(robots[i].right_motor);
    }
  }

  void collide(std::size_t robot, dGeomID hull, dGeomID thing, std::uint32_t other) {
    dContactGeom geoms[kMaxContacts];
    const int count = dCollide(hull, thing, kMaxContacts, geoms, sizeof(dContactGeom));
    if (count == 0) return;
    touches.push_back({static_cast<std::uint32_t>(robot + 1), other});
    for (int i = 0; i < count; ++i) merge_into(bumps, geoms[i], plan.mass_centre[2]);
  }

  void add_bumps() {
    for (const dContactGeom& bump : bumps) add_bump(bump);
    bumps.clear();
  }

  void add_bump(const dContactGeom& geom) {
    dContact contact{};
    contact.geom = geom;
    contact.surface.mode = dContactSoftCFM | dContactSoftERP | dContactFDir1 | dContactMu2;
    contact.surface.soft_cfm = kSoftness;
    contact.surface.soft_erp = kContactCorrection;
    contact.surface.mu = kHullGrip;  // along the floor; mu2, up and down: none
    contact.fdir1[0] = -geom.normal[1];
    contact.fdir1[1] = geom.normal[0];
    const dJointID joint = dJointCreateContact(ode.world(), ode.contacts(), &contact);
    dJointAttach(joint, dGeomGetBody(geom.g1), dGeomGetBody(geom.g2));
  }

  /// Has a knock tipped it so far that its hull may reach the floor?
  [[nodiscard]] static bool leans(const RobotBody& robot) {
    return dBodyGetRotation(robot.chassis)[10] < 0.995;
  }

  void collide_with_floor(const RobotBody& robot) {
    dContactGeom geoms[kMaxContacts];
    const int count = dCollide(robot.hull, statics.floor(), kMaxContacts, geoms, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.geom = geoms[i];
      dJointAttach(dJointCreateContact(ode.world(), ode.contacts(), &contact), robot.chassis, nullptr);
    }
  }

  OdeSession ode;
  std::vector<dContactGeom> bumps;
  BodyPlan plan;
  Statics statics;
  double hull_radius;
  double margin;
  std::uint32_t substeps;
  double substep_s;
  std::vector<RobotBody> robots;
  std::vector<Pose> poses;
  std::vector<double> left_rad;
  std::vector<double> right_rad;
  std::vector<double> push_n;
  std::vector<Touch> touches;
  Neighbours neighbours;
  std::vector<Point> places;
  std::vector<std::uint32_t> found;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

Dynamics::Dynamics(const WorldConfig& config, std::span<const Pose> starts)
    : impl_{std::make_unique<Impl>(config, starts)} {}
Dynamics::~Dynamics() = default;
Dynamics::Dynamics(Dynamics&&) noexcept = default;
Dynamics& Dynamics::operator=(Dynamics&&) noexcept = default;

void Dynamics::drive(std::size_t robot, double left_mps, double right_mps) {
  const double radius = impl_->plan.wheel_radius;
  dJointSetHingeParam(impl_->robots[robot].left_motor, dParamVel, left_mps / radius);
  dJointSetHingeParam(impl_->robots[robot].right_motor, dParamVel, right_mps / radius);
}

void Dynamics::free_wheels(std::size_t robot, bool free) {
  const double torque = free ? 0.0 : impl_->plan.motor_torque;
  dJointSetHingeParam(impl_->robots[robot].left_motor, dParamFMax, torque);
  dJointSetHingeParam(impl_->robots[robot].right_motor, dParamFMax, torque);
}

void Dynamics::push(std::size_t robot, double force_n) { impl_->push_n[robot] = force_n; }

void Dynamics::advance() { impl_->advance(); }

std::span<const Pose> Dynamics::poses() const { return impl_->poses; }
double Dynamics::left_wheel_rad(std::size_t robot) const { return impl_->left_rad[robot]; }
double Dynamics::right_wheel_rad(std::size_t robot) const { return impl_->right_rad[robot]; }

Stance Dynamics::stance(std::size_t robot) const {
  const RobotBody& body = impl_->robots[robot];
  Stance stance;
  static_cast<void>(pose_of(body, impl_->plan, &stance.lift_m));
  stance.tilt_rad = std::acos(std::clamp(dBodyGetRotation(body.chassis)[10], -1.0, 1.0));
  return stance;
}

std::span<const Touch> Dynamics::touches() const { return impl_->touches; }

}  // namespace caravan::world
