// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/avoidance.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

double clearance_m(const Encounter& encounter, double bearing_rad) {
  return encounter.seen.still.clearance_m({.bearing_rad = bearing_rad,
                                           .half_width_m = 0.5 * encounter.corridor_m,
                                           .surface_m = 0.0,
                                           .surface_per_metre = encounter.settings.surface_per_metre});
}

/// Like clearance_m(), with robots of known position as discs; 0 towards a robot close by.
double clearance_among_robots_m(const Encounter& encounter, double bearing_rad) {
  const Manoeuvres& settings = encounter.settings;
  const Point along = direction(encounter.seen.yaw_WB_rad + bearing_rad);
  double nearest = clearance_m(encounter, bearing_rad);
  for (const Neighbour& robot : encounter.seen.robots) {
    const Point apart = robot.p_WB - encounter.seen.p_WB;
    const double ahead = apart.dot(along);
    const double distance = apart.norm();
    if (distance < settings.robot_close_m && ahead > settings.robot_cosine * distance) return 0.0;
    if (ahead <= 0.0 || std::abs(cross(along, apart)) > 0.5 * encounter.corridor_m + settings.robot_radius_m)
      continue;
    nearest = std::min(nearest, std::max(0.0, ahead - settings.robot_radius_m));
  }
  return nearest;
}

/// Pauses and lets the other robot pass; goes round at every third attempt in the same place.
Manoeuvre let_pass(const Encounter& encounter) {
  if (encounter.attempt % 3 == 2) return go_round(encounter);
  const Manoeuvres& settings = encounter.settings;
  const double more_ms = 1000.0 * settings.pass_spread_s * encounter.draw;
  return {Pause{settings.pass_time + std::chrono::milliseconds{std::lround(more_ms)}}};
}

TurnTo turned_by(const Encounter& encounter, double bearing_rad) {
  return {wrapped(encounter.seen.yaw_WB_rad + bearing_rad)};
}

/// The rule in motion, for a robot of known position: it starts early enough that neither robot turns in
/// place.
Manoeuvre veer(const Encounter& encounter) {
  const Manoeuvres& settings = encounter.settings;
  const double side = encounter.meeting->passes_m > settings.veer_right_m ? -1.0 : 1.0;
  const double angle =
      encounter.goal_bearing_rad + side * (settings.veer_rad + settings.veer_spread_rad * encounter.draw);
  if (clearance_m(encounter, angle) < settings.room_m) return let_pass(encounter);
  return {Veer{turned_by(encounter, angle).yaw_WB_rad, settings.veer_m}};
}

}  // namespace

Manoeuvre turn_slightly_left(const Encounter& encounter) {
  if (encounter.meeting) return veer(encounter);
  const Manoeuvres& settings = encounter.settings;
  const double forward = settings.left_m + settings.left_spread_m * encounter.draw;
  // Tries larger angles while the position of another robot is known: a slight turn may not lead past one
  // close by.
  double left = settings.left_rad + settings.left_spread_rad * encounter.draw;
  while (left < settings.left_limit_rad) {
    if (clearance_among_robots_m(encounter, left) >= settings.room_m)
      return {turned_by(encounter, left), Go{forward}};
    if (encounter.seen.robots.empty()) break;
    left += settings.left_step_rad;
  }
  return let_pass(encounter);
}

Manoeuvre go_round(const Encounter& encounter) {
  // Alternates between left and right of the goal, at increasing angles.
  const Manoeuvres& settings = encounter.settings;
  const double first_side = encounter.attempt % 2 == 0 ? 1.0 : -1.0;
  for (const double aside : settings.round_rad) {
    for (const double side : {first_side, -first_side}) {
      const double bearing = wrapped(encounter.goal_bearing_rad + side * aside);
      if (clearance_among_robots_m(encounter, bearing) < settings.room_m) continue;
      return {turned_by(encounter, bearing), Go{settings.round_m + settings.round_spread_m * encounter.draw}};
    }
  }
  return free_itself(encounter);
}

Manoeuvre free_itself(const Encounter& encounter) {
  const Manoeuvres& settings = encounter.settings;
  const double further = std::min(encounter.attempt, static_cast<int>(settings.free_steps));
  const bool left_is_freer =
      clearance_m(encounter, settings.free_side_rad) >= clearance_m(encounter, -settings.free_side_rad);
  const double side = left_is_freer == (encounter.attempt % 2 == 0) ? 1.0 : -1.0;
  const double angle = side * (settings.free_turn_rad + settings.free_turn_step_rad * further +
                               settings.free_turn_spread_rad * encounter.draw);
  return {Go{-(settings.free_back_m + settings.free_back_step_m * further)}, turned_by(encounter, angle),
          Go{settings.free_forward_m + settings.free_forward_step_m * further}};
}

}  // namespace caravan::agent
