// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/avoidance.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

constexpr Time kLetsPass = std::chrono::milliseconds{800};
constexpr double kMostLeft_rad = 2.0;
constexpr double kRoom_m = 0.9;  // free distance from the base that a direction must have

double clearance_m(const Encounter& encounter, double bearing_rad) {
  return encounter.seen.still.clearance_m({.bearing_rad = bearing_rad,
                                           .half_width_m = 0.5 * encounter.corridor_m,
                                           .surface_m = 0.0,
                                           .surface_per_metre = 0.2});
}

/// The same, and robots that told where they are count as discs. One close by must not be approached at all.
double clearance_among_robots_m(const Encounter& encounter, double bearing_rad) {
  constexpr double kRobot_m = 0.25;
  constexpr double kClose_m = 0.9;
  constexpr double kApproaches = 0.1;  // cosine
  const Point along = direction(encounter.seen.yaw_WB_rad + bearing_rad);
  double nearest = clearance_m(encounter, bearing_rad);
  for (const Neighbour& robot : encounter.seen.robots) {
    const Point apart = robot.p_WB - encounter.seen.p_WB;
    const double ahead = apart.dot(along);
    const double distance = apart.norm();
    if (distance < kClose_m && ahead > kApproaches * distance) return 0.0;
    if (ahead <= 0.0 || std::abs(cross(along, apart)) > 0.5 * encounter.corridor_m + kRobot_m) continue;
    nearest = std::min(nearest, std::max(0.0, ahead - kRobot_m));
  }
  return nearest;
}

/// Stands a little and lets the other pass; every third time in the same place it goes round.
Manoeuvre let_pass(const Encounter& encounter) {
  if (encounter.attempt % 3 == 2) return go_round(encounter);
  return {Pause{kLetsPass + std::chrono::milliseconds{std::lround(1000.0 * encounter.draw)}}};
}

TurnTo turned_by(const Encounter& encounter, double bearing_rad) {
  return {wrapped(encounter.seen.yaw_WB_rad + bearing_rad)};
}

/// The same in motion, early enough that nobody has to turn on the spot: the other has told where it is.
Manoeuvre veer(const Encounter& encounter) {
  constexpr double kClearlyLeft_m = 0.3;
  const double side = encounter.meeting->passes_m > kClearlyLeft_m ? -1.0 : 1.0;
  const double angle = encounter.goal_bearing_rad + side * (0.55 + 0.15 * encounter.draw);
  if (clearance_m(encounter, angle) < kRoom_m) return let_pass(encounter);
  return {Veer{turned_by(encounter, angle).yaw_WB_rad, 0.7}};
}

}  // namespace

Manoeuvre turn_slightly_left(const Encounter& encounter) {
  if (encounter.meeting) return veer(encounter);
  const double forward = 0.5 + 0.4 * encounter.draw;
  // Further, where another robot is known to stand so close that slightly does not lead past it.
  double left = 0.5 + 0.3 * encounter.draw;
  while (left < kMostLeft_rad) {
    if (clearance_among_robots_m(encounter, left) >= kRoom_m)
      return {turned_by(encounter, left), Go{forward}};
    if (encounter.seen.robots.empty()) break;
    left += 0.4;
  }
  return let_pass(encounter);
}

Manoeuvre go_round(const Encounter& encounter) {
  // Alternately left and right of the goal, further and further.
  constexpr std::array<double, 8> kAside = {0.4, 0.7, 1.0, 1.3, 1.7, 2.1, 2.6, 3.1};
  const double first_side = encounter.attempt % 2 == 0 ? 1.0 : -1.0;
  for (const double aside : kAside) {
    for (const double side : {first_side, -first_side}) {
      const double bearing = wrapped(encounter.goal_bearing_rad + side * aside);
      if (clearance_among_robots_m(encounter, bearing) < kRoom_m) continue;
      return {turned_by(encounter, bearing), Go{0.5 + 0.3 * encounter.draw}};
    }
  }
  return free_itself(encounter);
}

Manoeuvre free_itself(const Encounter& encounter) {
  const double further = std::min(encounter.attempt, 6);
  const bool left_is_freer = clearance_m(encounter, 0.9) >= clearance_m(encounter, -0.9);
  const double side = left_is_freer == (encounter.attempt % 2 == 0) ? 1.0 : -1.0;
  const double angle = side * (0.6 + 0.25 * further + 0.3 * encounter.draw);
  return {Go{-(0.25 + 0.08 * further)}, turned_by(encounter, angle), Go{0.4 + 0.1 * further}};
}

}  // namespace caravan::agent
