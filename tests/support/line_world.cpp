// SPDX-License-Identifier: Apache-2.0
#include "tests/support/line_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot_agent/core/angle.hpp"

namespace caravan::test {
namespace {

using agent::cross;
using agent::direction;
using agent::Point;

constexpr double kRadius_m = 0.24;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kReflection = 0.92387953251128674;  // cosine of 22.5 degrees
constexpr double kRadioRange_m = 2.0;
constexpr std::array<double, 16> kX = {.069,  .114,  .148,  .166,  .166,  .148,  .114,  .069,
                                       -.157, -.203, -.237, -.255, -.255, -.237, -.203, -.157};
constexpr std::array<double, 16> kY = {.136,  .119,  .078,  .027,  -.027, -.078, -.119, -.136,
                                       -.136, -.119, -.078, -.027, .027,  .078,  .119,  .136};
constexpr std::array<double, 16> kHeading = {90,  50,   30,   10,   -10, -30, -50, -90,
                                             -90, -130, -150, -170, 170, 150, 130, 90};

/// Distance along a ray to a wall; negative when the echo is lost.
double hit(const Point& from, const Point& along, const Wall& wall) {
  const Point side = wall.b - wall.a;
  const double denominator = cross(along, side);
  if (std::abs(denominator) < 1e-12) return kInfinity;
  const double distance = cross(wall.a - from, side) / denominator;
  const double share = cross(wall.a - from, along) / denominator;
  if (distance < 0.0 || share < 0.0 || share > 1.0) return kInfinity;
  const double incidence = std::abs(cross(along, side)) / side.norm();
  return incidence > kReflection ? distance : -distance;
}

double distance_to(const Wall& wall, const Point& p) {
  const Point along = wall.b - wall.a;
  const double share = std::clamp((p - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (wall.a + share * along - p).norm();
}

}  // namespace

std::vector<Wall> rectangle(const Point& centre, double width_m, double height_m, double yaw_rad) {
  const Point x = 0.5 * width_m * direction(yaw_rad);
  const Point y = 0.5 * height_m * direction(yaw_rad + 0.5 * std::numbers::pi);
  const std::array<Point, 4> corners = {centre + x + y, centre - x + y, centre - x - y, centre + x - y};
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < 4; ++i) walls.push_back({corners[i], corners[(i + 1) % 4]});
  return walls;
}

void LineWorld::add_robot(const Point& p_WB, double yaw_WB_rad) {
  agent::Config config = config_;
  config.id = agent::RobotId{static_cast<std::uint16_t>(agents_.size() + 1)};
  agents_.emplace_back(config);
  add_dead(p_WB);
  bodies_.back().alive = true;
  bodies_.back().yaw_WB_rad = yaw_WB_rad;
}

void LineWorld::add_dead(const Point& p_WB) {
  bodies_.push_back({.p_WB = p_WB, .alive = false});
  outputs_.emplace_back();
  heard_.emplace_back();
  paths_.emplace_back();
  delivered_.push_back(0);
  closed_.push_back(false);
  events_.emplace_back();
  stood_at_.push_back(p_WB);
  stood_since_.push_back(0.0);
}

int LineWorld::count(std::size_t robot, const std::string& event) const {
  const auto found = events_[robot].find(event);
  return found == events_[robot].end() ? 0 : found->second;
}

double LineWorld::range_m(std::size_t robot, std::size_t sonar) const {
  const Body& self = bodies_[robot];
  const Point ahead = direction(self.yaw_WB_rad);
  const Point left{-ahead.y(), ahead.x()};
  const Point from = self.p_WB + kX[sonar] * ahead + kY[sonar] * left;
  double nearest_of_all = kInfinity;
  for (const double aside : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
    const Point along = direction(self.yaw_WB_rad + kHeading[sonar] * std::numbers::pi / 180.0 + aside);
    double nearest = config_.sonar_range_m;
    bool lost = true;
    const auto offer = [&](double distance) {
      if (std::abs(distance) >= nearest) return;
      nearest = std::abs(distance);
      lost = distance < 0.0;
    };
    for (const Wall& wall : walls_) offer(hit(from, along, wall));
    for (std::size_t other = 0; other < bodies_.size(); ++other) {
      const double reach = nearest + 1.0;
      if (other == robot || (bodies_[other].p_WB - from).squaredNorm() > reach * reach) continue;
      for (const Wall& side : rectangle(bodies_[other].p_WB, 0.48, 0.38, bodies_[other].yaw_WB_rad)) {
        offer(hit(from, along, side));
      }
    }
    if (!lost) nearest_of_all = std::min(nearest_of_all, nearest);
  }
  return nearest_of_all;
}

agent::Sensors LineWorld::sense(std::size_t robot) const {
  agent::Sensors sensors;
  for (std::size_t i = 0; i < agent::kSonarCount; ++i) sensors.sonar_range_m[i] = range_m(robot, i);
  sensors.p_WB = bodies_[robot].p_WB;
  sensors.yaw_WB_rad = bodies_[robot].yaw_WB_rad;
  sensors.holding = bodies_[robot].holding;
  return sensors;
}

bool LineWorld::is_free(std::size_t robot, const Point& p_WB) const {
  const auto nearer = [&](const Point& a, const Point& b) {  // than now, and too near
    const double then = (p_WB - a).norm();
    return then < 2.0 * kRadius_m && then < (b - a).norm();
  };
  for (std::size_t other = 0; other < bodies_.size(); ++other) {
    if (other != robot && nearer(bodies_[other].p_WB, bodies_[robot].p_WB)) return false;
  }
  return std::none_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
    const double then = distance_to(wall, p_WB);
    return then < kRadius_m && then < distance_to(wall, bodies_[robot].p_WB);
  });
}

void LineWorld::move(std::size_t robot, const agent::Wheels& wheels) {
  Body& body = bodies_[robot];
  const double speed = 0.5 * (wheels.left_mps + wheels.right_mps);
  body.yaw_WB_rad =
      agent::wrapped(body.yaw_WB_rad + kStep_s * (wheels.right_mps - wheels.left_mps) / config_.track_m);
  const Point there = body.p_WB + kStep_s * speed * direction(body.yaw_WB_rad);
  if (is_free(robot, there)) {
    body.p_WB = there;
  } else {
    ++held_;
  }
}

void LineWorld::grip(std::size_t robot, bool closed) {
  Body& body = bodies_[robot];
  if (closed && !closed_[robot] && (body.p_WB - config_.source).norm() <= config_.service_radius_m) {
    body.holding = true;
  }
  if (!closed && closed_[robot] && body.holding) {
    body.holding = false;
    if ((body.p_WB - config_.destination).norm() <= config_.service_radius_m) ++delivered_[robot];
  }
  closed_[robot] = closed;
}

void LineWorld::deliver_frames() {
  for (auto& frames : heard_) frames.clear();
  for (std::size_t to = 0; to < agents_.size(); ++to) {
    for (std::size_t from = 0; from < agents_.size(); ++from) {
      if (from == to || !bodies_[from].alive) continue;
      if ((bodies_[from].p_WB - bodies_[to].p_WB).norm() > kRadioRange_m) continue;
      for (const agent::Frame& frame : outputs_[from].frames) {
        if (frame.channel == outputs_[to].tuned) heard_[to].push_back(frame);
      }
    }
  }
}

void LineWorld::step() {
  const agent::Time now{static_cast<std::int64_t>(step_) * 32'000'000};
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!bodies_[i].alive) continue;
    outputs_[i] = agents_[i].step({now, sense(i), heard_[i]});
    if (outputs_[i].report.path_changed) paths_[i] = outputs_[i].report.path;
    for (const agent::Event& event : outputs_[i].report.events) ++events_[i][event.name];
  }
  deliver_frames();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!bodies_[i].alive) continue;
    grip(i, outputs_[i].gripper_closed);
    move(i, outputs_[i].wheels);
    if ((bodies_[i].p_WB - stood_at_[i]).norm() > 0.5) {
      stood_at_[i] = bodies_[i].p_WB;
      stood_since_[i] = now_s();
    }
    longest_stand_s_ = std::max(longest_stand_s_, now_s() - stood_since_[i]);
  }
  ++step_;
}

void LineWorld::run_for(double seconds) {
  for (const double end = now_s() + seconds; now_s() < end;) step();
}

}  // namespace caravan::test
