// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surfaces.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

// Shares of the body's width: too close together for the robot to drive between two of them.
constexpr std::array<double, 5> kAcrossTheFront = {-0.5, -0.25, 0.0, 0.25, 0.5};

bool within(const Point& a, const Point& b, double distance_m) {
  return (a - b).squaredNorm() < distance_m * distance_m;
}

/// Rotates a vector from frame B to W.
Point turned(const Point& v_B, const Point& ahead_W) {
  return v_B.x() * ahead_W + v_B.y() * Point{-ahead_W.y(), ahead_W.x()};
}

}  // namespace

Surfaces::Surfaces(const SurfaceMemory& memory, const PatienceSettings& patience, bool recognises_high)
    : memory_{memory},
      patience_{patience},
      has_map_{memory.duration > memory.recent || recognises_high},
      map_{memory} {}

void Surfaces::see(const Perception& seen) {
  forget(seen);
  extended_.clear();
  // A robot without a reported position is indistinguishable from other things.
  if (seen.robot_near && seen.robots.empty()) return;
  const Point ahead = direction(seen.yaw_WB_rad);
  for (const Echo& echo : seen.still.echoes()) {
    if (echo.range_m > memory_.exact_range_m) continue;
    const Point at = seen.p_WB + turned(echo.p_B, ahead);
    remember({at, seen.now});
    if (has_map_) map_.see(at, echo.range_m, seen.now);
    follow(echo.sonar, turned(echo.across_B, ahead), at, seen.now);
  }
}

void Surfaces::forget(const Perception& seen) {
  std::erase_if(places_, [&](const Place& place) {
    if (seen.now - place.seen > memory_.recent || !within(place.at, seen.p_WB, memory_.recent_m)) return true;
    return std::ranges::any_of(seen.robots, [&](const Neighbour& robot) {
      return within(place.at, robot.p_WB, memory_.robot_radius_m);
    });
  });
  if (!has_map_) return;
  if (patience_.is_lost(seen)) map_.forget_around(seen.p_WB, patience_.forget_radius_m());
  for (const Neighbour& robot : seen.robots) map_.forget_around(robot.p_WB, memory_.robot_radius_m);
}

void Surfaces::remember(const Place& place) {
  const auto known = std::ranges::find_if(
      places_, [&](const Place& one) { return within(one.at, place.at, memory_.same_place_m); });
  if (known == places_.end()) {
    places_.push_back(place);
  } else {
    *known = place;
  }
}

void Surfaces::follow(std::size_t sonar, const Point& across_W, const Point& at, Time now) {
  Place& before = followed_[sonar];
  const Point along = at - before.at;
  const double length = along.norm();
  if (now - before.seen > memory_.wall_time || length > memory_.wall_longest_m) {
    before = {at, now};
    return;
  }
  if (length < memory_.wall_shortest_m || std::abs(along.dot(across_W)) < memory_.wall_cosine * length)
    return;
  for (const double on : memory_.wall_extension_m) extended_.emplace_back(at + (on / length) * along);
  if (length > 2.0 * memory_.wall_shortest_m) before = {at - (memory_.wall_shortest_m / length) * along, now};
}

void Surfaces::touch_ahead(const Perception& seen, const Body& body) {
  const Point ahead = direction(seen.yaw_WB_rad);
  for (const double part : kAcrossTheFront) {
    const Point at_B{body.ahead_m + memory_.touched_ahead_m, part * body.width_m};
    const Point at = seen.p_WB + turned(at_B, ahead);
    remember({at, seen.now});
    if (has_map_) map_.touch(at, seen.now);
  }
}

std::vector<Point> Surfaces::near(const Point& p_WB, Time now) const {
  std::vector<Point> result;
  for (const Place& place : places_) {
    if (within(place.at, p_WB, memory_.reach_m)) result.push_back(place.at);
  }
  map_.add_near(p_WB, {now - memory_.duration, now - memory_.recent}, result);
  for (const Point& at : extended_) {
    if (within(at, p_WB, memory_.reach_m)) result.push_back(at);
  }
  return result;
}

}  // namespace caravan::agent
