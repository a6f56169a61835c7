// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "world_server/physics/bumps.hpp"
#include "world_server/physics/ode_session.hpp"
#include "world_server/physics/robot_body.hpp"
#include "world_server/physics/statics.hpp"
#include "world_server/shapes/neighbours.hpp"

namespace caravan::world {
namespace {

constexpr double kGravity = 9.81;
// Share of an error in the joints' positions that one physics step takes back. A wheel that moves along its
// tangent leaves its circle a little in each step: what is not taken back widens the track.
constexpr double kJointCorrection = 0.8;
// Keeps resting contacts closed, so that wheels neither bounce nor rattle.
constexpr double kSurfaceLayer = 0.0005;
// A body that got into another is pushed out no faster than this, so that nothing is shot away.
constexpr double kMaxPushOut = 1.0;
constexpr double kUpright = 0.995;  // cosine of the tilt up to which a hull keeps off the floor
constexpr int kFloorContacts = 4;

}  // namespace

struct Dynamics::Impl {
  Impl(const WorldConfig& config, std::span<const Pose> starts)
      : plan{config.robots},
        bumps{plan.mass_centre[2]},
        spring{calm_spring(config.robots.mass_kg, config.step_s / config.substeps)},
        robots_collide{config.robots.solid},
        statics{config, body_radius_m(config.robots) + reach_margin(config)},
        hull_radius{body_radius_m(config.robots)},
        margin{reach_margin(config)},
        substeps{config.substeps},
        substep_s{config.step_s / config.substeps} {
    ode.prepare_thread();
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
    pairs.clear();
    if (!robots_collide) return;
    neighbours.rebuild(places, 2.0 * (hull_radius + margin));
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      neighbours.near(places[i], found);
      for (const std::uint32_t k : found) {
        if (k > i) pairs.emplace_back(i, k);
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
      bump_statics(i);
      if (dBodyGetRotation(robot.chassis)[10] < kUpright) collide_with_floor(robot);
    }
    bump_robots();
    dWorldStep(ode.world(), substep_s);
    dJointGroupEmpty(ode.contacts());
    for (std::size_t i = 0; i < robots.size(); ++i) {
      left_rad[i] += substep_s * dJointGetHingeAngleRate(robots[i].left_motor);
      right_rad[i] += substep_s * dJointGetHingeAngleRate(robots[i].right_motor);
    }
  }

  void bump_statics(std::size_t robot) {
    bumps.clear();
    bool touched = false;
    statics.near(places[robot], hull_radius,
                 [&](dGeomID thing) { touched = bumps.add(robots[robot].hull, thing) || touched; });
    if (touched) touches.push_back({static_cast<std::uint32_t>(robot + 1), 0});
    hold_apart(ode, bumps.all());
  }

  /// Two robots that touch nobody else are held apart by the solver. In a crowd springs do it: the solver
  /// takes all robots that hold each other as one problem, whose time grows with the cube of their number.
  void bump_robots() {
    meetings.clear();
    partners.assign(robots.size(), 0);
    for (const auto& [a, b] : pairs) {
      const Point apart = places[b] - places[a];
      if (dot(apart, apart) > 4.0 * hull_radius * hull_radius) continue;
      bumps.clear();
      if (!bumps.add(robots[a].hull, robots[b].hull)) continue;
      touches.push_back({a + 1, b + 1});
      ++partners[a];
      ++partners[b];
      meetings.push_back({a, b, {bumps.all().begin(), bumps.all().end()}});
    }
    for (const Meeting& meeting : meetings) {
      const bool is_crowd = partners[meeting.a] > 1 || partners[meeting.b] > 1;
      is_crowd ? push_apart(meeting.contacts, spring) : hold_apart(ode, meeting.contacts);
    }
  }

  /// A hull that a knock has tipped rests on the floor with its edge.
  void collide_with_floor(const RobotBody& robot) {
    dContactGeom geoms[kFloorContacts];
    const int count = dCollide(robot.hull, statics.floor(), kFloorContacts, geoms, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.geom = geoms[i];
      dJointAttach(dJointCreateContact(ode.world(), ode.contacts(), &contact), robot.chassis, nullptr);
    }
  }

  /// Two robots that touch in this physics step.
  struct Meeting {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::vector<dContactGeom> contacts;
  };

  OdeSession ode;
  BodyPlan plan;
  Bumps bumps;
  Spring spring;
  bool robots_collide;
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
  std::vector<Meeting> meetings;
  std::vector<std::uint32_t> partners;  // by robot: how many others it touches
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

void Dynamics::place(std::size_t robot, const Pose& pose) {
  stand(impl_->robots[robot], impl_->plan, pose);
  impl_->poses[robot] = pose_of(impl_->robots[robot], impl_->plan);
}

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
