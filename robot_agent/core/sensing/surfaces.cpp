// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surfaces.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

constexpr Time kRemembers = 20s;
constexpr double kFarthest_m = 3.0;  // from the robot
constexpr double kExact_m = 1.2;     // beyond this range an echo does not say well enough where it is from
constexpr double kSamePlace_m = 0.05;
constexpr double kReach_m = 0.8;
constexpr double kRobot_m = 0.5;  // around the axle of one

// Two echoes of a sonar on one wall tell its direction when they are this far apart,
constexpr double kShortest_m = 0.08;
constexpr double kLongest_m = 0.4;
constexpr Time kFollows = 1s;     // this soon after each other,
constexpr double kAcross = 0.75;  // and on a line that the sonar could see (cosine)
constexpr std::array<double, 3> kGoesOn_m = {0.1, 0.2, 0.3};

constexpr double kInFront_m = 0.02;
constexpr std::array<double, 5> kAcrossTheFront = {-0.5, -0.25, 0.0, 0.25, 0.5};  // of the body's width

bool within(const Point& a, const Point& b, double distance_m) {
  return (a - b).squaredNorm() < distance_m * distance_m;
}

/// From frame B to W, without the offset.
Point turned(const Point& v_B, const Point& ahead_W) {
  return v_B.x() * ahead_W + v_B.y() * Point{-ahead_W.y(), ahead_W.x()};
}

}  // namespace

Surfaces::Surfaces(const SurfaceMemory& memory, const PatienceSettings& patience, bool recognises_high)
    : memory_{memory.duration}, patience_{patience}, has_map_{memory_ > kRemembers || recognises_high} {}

void Surfaces::see(const Perception& seen) {
  forget(seen);
  goes_on_.clear();
  // A robot that does not tell where it is looks like any other thing.
  if (seen.robot_near && seen.robots.empty()) return;
  const Point ahead = direction(seen.yaw_WB_rad);
  for (const Echo& echo : seen.still.echoes()) {
    if (echo.range_m > kExact_m) continue;
    const Point at = seen.p_WB + turned(echo.p_B, ahead);
    remember({at, seen.now});
    if (has_map_) map_.see(at, echo.range_m, seen.now);
    follow(echo.sonar, turned(echo.across_B, ahead), at, seen.now);
  }
}

void Surfaces::forget(const Perception& seen) {
  std::erase_if(places_, [&](const Place& place) {
    if (seen.now - place.seen > kRemembers || !within(place.at, seen.p_WB, kFarthest_m)) return true;
    return std::ranges::any_of(
        seen.robots, [&](const Neighbour& robot) { return within(place.at, robot.p_WB, kRobot_m); });
  });
  if (!has_map_) return;
  if (patience_.is_lost(seen)) map_.forget_around(seen.p_WB, Patience::kForgets_m);
  for (const Neighbour& robot : seen.robots) map_.forget_around(robot.p_WB, kRobot_m);
}

void Surfaces::remember(const Place& place) {
  const auto known =
      std::ranges::find_if(places_, [&](const Place& one) { return within(one.at, place.at, kSamePlace_m); });
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
  if (now - before.seen > kFollows || length > kLongest_m) {
    before = {at, now};
    return;
  }
  if (length < kShortest_m || std::abs(along.dot(across_W)) < kAcross * length) return;
  for (const double on : kGoesOn_m) goes_on_.emplace_back(at + (on / length) * along);
  if (length > 2.0 * kShortest_m) before = {at - (kShortest_m / length) * along, now};
}

void Surfaces::touch_ahead(const Perception& seen, const Body& body) {
  const Point ahead = direction(seen.yaw_WB_rad);
  for (const double part : kAcrossTheFront) {
    const Point at_B{body.ahead_m + kInFront_m, part * body.width_m};
    const Point at = seen.p_WB + turned(at_B, ahead);
    remember({at, seen.now});
    if (has_map_) map_.touch(at, seen.now);
  }
}

std::vector<Point> Surfaces::near(const Point& p_WB, Time now) const {
  std::vector<Point> result;
  for (const Place& place : places_) {
    if (within(place.at, p_WB, kReach_m)) result.push_back(place.at);
  }
  map_.add_near(p_WB, {now - memory_, now - kRemembers}, result);
  for (const Point& at : goes_on_) {
    if (within(at, p_WB, kReach_m)) result.push_back(at);
  }
  return result;
}

}  // namespace caravan::agent
