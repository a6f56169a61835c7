// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "world_server/physics/physics_error.hpp"
#include "world_server/physics/stage.hpp"
#include "world_server/shapes/neighbours.hpp"

namespace caravan::world {

struct Dynamics::Impl {
  Impl(const WorldConfig& config, std::span<const Pose> starts)
      : plan{config.robots},
        robots_collide{config.robots.solid},
        hull_radius{body_radius_m(config.robots)},
        margin{reach_margin(config)},
        substeps{config.substeps},
        step_s{config.step_s},
        substep_s{config.step_s / config.substeps},
        statics{config, hull_radius + margin},
        alone{config, statics, 1},
        couple{config, statics, 2},
        poses{starts.begin(), starts.end()},
        present(starts.size(), true),
        company(starts.size()),
        partners(starts.size()) {
    for (const Pose& start : starts) {
      robots.push_back({.motor_torque = plan.motor_torque});
      stand(robots.back(), plan, start);
    }
  }

  /// Twice the distance that a robot may move in one step.
  static double reach_margin(const WorldConfig& config) {
    return 2.0 * config.robots.wheel_limit_mps * config.step_s + 0.02;
  }

  void advance() {
    OdeSession::prepare_thread();
    touches.clear();
    complaint.clear();
    find_pairs();
    for (std::uint32_t robot = 0; robot < robots.size(); ++robot) {
      if (present[robot] && !company[robot]) naming({robot}, [&] { step_loner(robot); });
    }
    if (!pairs.empty()) {
      for (std::uint32_t i = 0; i < substeps; ++i) step_company();
    }
    for (RobotState& robot : robots) robot.push_n = 0.0;
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  }

  /// Finds the robots that could touch in this step, each pair once, sorted.
  void find_pairs() {
    pairs.clear();
    if (!robots_collide) return;
    places.clear();
    for (const Pose& pose : poses) places.push_back({pose.x_m, pose.y_m});
    neighbours.rebuild(places, 2.0 * (hull_radius + margin));
    std::fill(company.begin(), company.end(), false);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      if (!present[i]) continue;
      neighbours.near(places[i], found);
      for (const std::uint32_t k : found) {
        if (k <= i) continue;
        pairs.emplace_back(i, k);
        company[i] = company[k] = true;
      }
    }
  }

  /// A robot that can touch only the floor needs one physics step: it keeps the wheels on their axle and the
  /// robot on its arc.
  void step_loner(std::uint32_t robot) {
    bool free = is_upright(robots[robot]);
    statics.near(base_of(robot), hull_radius + margin, [&](dGeomID) { free = false; });
    if (free) {
      step_free(robot);
      return;
    }
    for (std::uint32_t i = 0; i < substeps; ++i) step_alone(robot);
  }

  void step_free(std::uint32_t robot) {
    RobotState& state = robots[robot];
    const std::array<double, 3> from = state.position;
    alone.enter(0, state);
    alone.stand(0, state);
    alone.step(step_s);
    alone.leave(0, state);
    bend(state, from, step_s);
    moved(robot, step_s);
  }

  void step_alone(std::uint32_t robot) {
    RobotState& state = robots[robot];
    alone.enter(0, state);
    alone.stand(0, state);
    if (alone.bump(0, base_of(robot))) touches.push_back({robot + 1, 0});
    alone.step(substep_s);
    alone.leave(0, state);
    moved(robot, substep_s);
  }

  void moved(std::uint32_t robot, double seconds) {
    RobotState& state = robots[robot];
    state.left_rad += seconds * state.left_rate;
    state.right_rad += seconds * state.right_rate;
    poses[robot] = pose_of(state, plan);
    const Pose& pose = poses[robot];
    if (!std::isfinite(pose.x_m + pose.y_m + pose.yaw_rad))
      throw PhysicsError{"its pose is no longer finite"};
  }

  /// Runs `work` for these robots; ODE's errors and warnings get their numbers.
  template <typename Work>
  void naming(std::initializer_list<std::uint32_t> who, const Work& work) {
    const auto named = [&](const std::string& what) {
      std::string names;
      for (const std::uint32_t robot : who)
        names += (names.empty() ? "robot " : " and robot ") + std::to_string(robot + 1);
      return names + ": " + what;
    };
    try {
      work();
    } catch (const PhysicsError& error) {
      throw PhysicsError{named(error.what())};
    }
    const std::string said = OdeSession::take_complaint();
    if (!said.empty() && complaint.empty()) complaint = named(said);
  }

  [[nodiscard]] Point base_of(std::uint32_t robot) const { return {poses[robot].x_m, poses[robot].y_m}; }

  /// One physics step of all robots in contact. The solver separates two robots that touch no other, as one
  /// problem. In a crowd springs do it: the solver would treat all robots in contact as one problem, whose
  /// time grows with the cube of their number.
  void step_company() {
    find_meetings();
    for (const Meeting& meeting : meetings) {
      if (is_crowd(meeting)) naming({meeting.a, meeting.b}, [&] { push_apart(meeting); });
    }
    for (const Meeting& meeting : meetings) {
      if (!is_crowd(meeting)) naming({meeting.a, meeting.b}, [&] { step_couple(meeting); });
    }
    for (std::uint32_t robot = 0; robot < robots.size(); ++robot) {
      if (company[robot] && partners[robot] != kStepped) naming({robot}, [&] { step_alone(robot); });
    }
  }

  void find_meetings() {
    meetings.clear();
    std::fill(partners.begin(), partners.end(), 0);
    for (const auto& [a, b] : pairs) {
      const Point apart = base_of(b) - base_of(a);
      if (dot(apart, apart) > 4.0 * hull_radius * hull_radius) continue;
      bool touching = false;
      naming({a, b}, [&, one = a, other = b] {
        couple.enter(0, robots[one]);
        couple.enter(1, robots[other]);
        touching = couple.meet();
      });
      if (!touching) continue;
      touches.push_back({a + 1, b + 1});
      ++partners[a];
      ++partners[b];
      meetings.push_back({a, b, {couple.contacts().begin(), couple.contacts().end()}});
    }
  }

  /// Two robots that touch in this physics step.
  struct Meeting {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::vector<dContactGeom> contacts;
  };
  [[nodiscard]] bool is_crowd(const Meeting& meeting) const {
    return partners[meeting.a] > 1 || partners[meeting.b] > 1;
  }

  void push_apart(const Meeting& meeting) {
    couple.enter(0, robots[meeting.a]);
    couple.enter(1, robots[meeting.b]);
    couple.push_apart(meeting.contacts);
    couple.leave_forces(0, robots[meeting.a]);
    couple.leave_forces(1, robots[meeting.b]);
  }

  void step_couple(const Meeting& meeting) {
    const std::array two{meeting.a, meeting.b};
    for (std::size_t place = 0; place < two.size(); ++place) {
      couple.enter(place, robots[two[place]]);
      couple.stand(place, robots[two[place]]);
      if (couple.bump(place, base_of(two[place]))) touches.push_back({two[place] + 1, 0});
    }
    couple.hold_apart(meeting.contacts);
    couple.step(substep_s);
    for (std::size_t place = 0; place < two.size(); ++place) {
      couple.leave(place, robots[two[place]]);
      moved(two[place], substep_s);
      partners[two[place]] = kStepped;
    }
  }

  static constexpr std::uint32_t kStepped = ~0U;

  BodyPlan plan;
  bool robots_collide;
  double hull_radius;
  double margin;
  std::uint32_t substeps;
  double step_s;
  double substep_s;
  Statics statics;
  Stage alone;
  Stage couple;
  std::vector<RobotState> robots;
  std::vector<Pose> poses;
  std::vector<bool> present;  // by robot: whether it is in the world
  std::vector<Touch> touches;
  std::string complaint;  // of the last step
  Neighbours neighbours;
  std::vector<Point> places;
  std::vector<std::uint32_t> found;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<bool> company;  // by robot: whether it is in one of the pairs
  std::vector<Meeting> meetings;
  std::vector<std::uint32_t>
      partners;  // by robot: number of others it touches; kStepped: already stepped with one
};

Dynamics::Dynamics(const WorldConfig& config, std::span<const Pose> starts)
    : impl_{std::make_unique<Impl>(config, starts)} {}
Dynamics::~Dynamics() = default;
Dynamics::Dynamics(Dynamics&&) noexcept = default;
Dynamics& Dynamics::operator=(Dynamics&&) noexcept = default;

void Dynamics::drive(std::size_t robot, double left_mps, double right_mps) {
  impl_->robots[robot].left_target = left_mps / impl_->plan.wheel_radius;
  impl_->robots[robot].right_target = right_mps / impl_->plan.wheel_radius;
}

void Dynamics::free_wheels(std::size_t robot, bool free) {
  impl_->robots[robot].motor_torque = free ? 0.0 : impl_->plan.motor_torque;
}

void Dynamics::push(std::size_t robot, double force_n) { impl_->robots[robot].push_n = force_n; }

void Dynamics::place(std::size_t robot, const Pose& pose) {
  stand(impl_->robots[robot], impl_->plan, pose);
  impl_->poses[robot] = pose_of(impl_->robots[robot], impl_->plan);
  impl_->present[robot] = true;
}

void Dynamics::remove(std::size_t robot) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  impl_->poses[robot] = {kNowhere, kNowhere, kNowhere};
  impl_->present[robot] = false;
}

void Dynamics::advance() { impl_->advance(); }

std::span<const Pose> Dynamics::poses() const { return impl_->poses; }
double Dynamics::left_wheel_rad(std::size_t robot) const { return impl_->robots[robot].left_rad; }
double Dynamics::right_wheel_rad(std::size_t robot) const { return impl_->robots[robot].right_rad; }

Stance Dynamics::stance(std::size_t robot) const {
  const RobotState& state = impl_->robots[robot];
  return {.tilt_rad = std::acos(std::clamp(uprightness_of(state), -1.0, 1.0)),
          .lift_m = lift_of(state, impl_->plan)};
}

const std::string& Dynamics::complaint() const { return impl_->complaint; }
std::span<const Touch> Dynamics::touches() const { return impl_->touches; }

}  // namespace caravan::world
