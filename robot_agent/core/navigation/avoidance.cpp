// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/avoidance.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

constexpr Time kLetsPass = std::chrono::milliseconds{800};
constexpr double kRoom_m = 0.9;  // free distance from the base that a direction must have

double clearance_m(const Encounter& encounter, double bearing_rad) {
  return encounter.seen.around.clearance_m({.bearing_rad = bearing_rad,
                                            .half_width_m = 0.5 * encounter.config.corridor_m,
                                            .surface_m = 0.0,
                                            .surface_per_metre = 0.2});
}

TurnTo turned_by(const Encounter& encounter, double bearing_rad) {
  return {wrapped(encounter.seen.yaw_WB_rad + bearing_rad)};
}

}  // namespace

Manoeuvre turn_slightly_left(const Encounter& encounter) {
  const double left = 0.5 + 0.3 * encounter.draw;
  const double forward = 0.5 + 0.4 * encounter.draw;
  if (clearance_m(encounter, left) < kRoom_m) {
    if (encounter.attempt % 3 == 2) return go_round(encounter);
    return {Pause{kLetsPass + std::chrono::milliseconds{std::lround(1000.0 * encounter.draw)}}};
  }
  return {turned_by(encounter, left), Go{forward}};
}

Manoeuvre go_round(const Encounter& encounter) {
  // Alternately left and right of the goal, further and further.
  constexpr std::array<double, 6> kAside = {0.4, 0.7, 1.0, 1.3, 1.7, 2.1};
  const double first_side = encounter.attempt % 2 == 0 ? 1.0 : -1.0;
  for (const double aside : kAside) {
    for (const double side : {first_side, -first_side}) {
      const double bearing = wrapped(encounter.goal_bearing_rad + side * aside);
      if (clearance_m(encounter, bearing) < kRoom_m) continue;
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
