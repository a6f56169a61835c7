// SPDX-License-Identifier: Apache-2.0
#include "tests/support/line_world.hpp"

#include <algorithm>
#include <cmath>

#include "robot_agent/core/angle.hpp"
#include "robot_agent/core/body.hpp"

namespace caravan::test {
namespace {

using agent::direction;
using agent::Point;

constexpr double kRadius_m = 0.24;
constexpr double kRadioRange_m = 2.0;
double distance_to(const Wall& wall, const Point& p) {
  const Point along = wall.b - wall.a;
  const double share = std::clamp((p - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (wall.a + share * along - p).norm();
}

}  // namespace

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

agent::Sensors LineWorld::sense(std::size_t robot) const {
  const Body& self = bodies_[robot];
  const double reach = config_.sonars.range_m + 1.0;
  std::vector<Wall> walls;
  for (const Wall& wall : walls_) {
    if (distance_to(wall, self.p_WB) < reach) walls.push_back(wall);
  }
  for (std::size_t other = 0; other < bodies_.size(); ++other) {
    if (other == robot || (bodies_[other].p_WB - self.p_WB).norm() > reach) continue;
    const auto sides = rectangle(bodies_[other].p_WB, 0.48, 0.38, bodies_[other].yaw_WB_rad);
    walls.insert(walls.end(), sides.begin(), sides.end());
  }
  agent::Sensors sensors;
  sensors.sonar_range_m = sonar_ranges_m(walls, self.p_WB, self.yaw_WB_rad, config_.sonars.range_m);
  sensors.p_WB = self.p_WB;
  sensors.yaw_WB_rad = self.yaw_WB_rad;
  sensors.holding = self.holding;
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
      agent::wrapped(body.yaw_WB_rad + kStep_s * (wheels.right_mps - wheels.left_mps) / config_.body.track_m);
  const Point there = body.p_WB + kStep_s * speed * direction(body.yaw_WB_rad);
  if (is_free(robot, there)) {
    body.p_WB = there;
  } else {
    ++held_;
  }
}

void LineWorld::grip(std::size_t robot, bool closed) {
  Body& body = bodies_[robot];
  if (closed && !closed_[robot] &&
      (body.p_WB - config_.task.source).norm() <= config_.task.service_radius_m) {
    body.holding = true;
  }
  if (!closed && closed_[robot] && body.holding) {
    body.holding = false;
    if ((body.p_WB - config_.task.destination).norm() <= config_.task.service_radius_m) ++delivered_[robot];
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
        if (frame.channel != outputs_[to].tuned) continue;
        heard_[to].push_back({.channel = frame.channel, .bytes = frame.bytes});
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
  count_contacts();
  ++step_;
}

void LineWorld::count_contacts() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const agent::Pose one{bodies_[i].p_WB, bodies_[i].yaw_WB_rad};
      const agent::Pose other{bodies_[j].p_WB, bodies_[j].yaw_WB_rad};
      const bool near = (one.p_WB - other.p_WB).squaredNorm() < 1.0;
      const bool touch =
          near && bodies_[i].alive && bodies_[j].alive && agent::distance_m(one, other, config_.body) <= 0.0;
      if (!touch) {
        touching_.erase({i, j});
      } else if (touching_.insert({i, j}).second) {
        ++contacts_;
      }
    }
  }
}

void LineWorld::run_for(double seconds) {
  for (const double end = now_s() + seconds; now_s() < end;) step();
}

}  // namespace caravan::test
