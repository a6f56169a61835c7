// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/steering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caravan::agent {
namespace {

// Geometric tolerance, not a clearance: a surface that reaches less than this beyond the end of the body
// counts as beside it.
constexpr double kTolerance_m = 0.01;

double turn_rate(double bearing_rad, const Driving& driving) {
  return std::clamp(driving.turn_gain_per_s * bearing_rad, -driving.turn_limit_radps,
                    driving.turn_limit_radps);
}

Corridor beside_the_body(const Surroundings& around, const Body& body, double bearing_rad, double beyond_m) {
  return {.bearing_rad = bearing_rad,
          .half_width_m = 0.5 * body.width_m + body.side_margin_m,
          .surface_m = 0.0,
          .surface_per_metre = around.cone_per_metre(),
          .beyond_m = beyond_m};
}

}  // namespace

Wheels wheels_for(double speed_mps, double turn_radps, const Body& body) {
  const double difference = 0.5 * turn_radps * body.track_m;
  Wheels wheels{speed_mps - difference, speed_mps + difference};
  const double fastest = std::max(std::abs(wheels.left_mps), std::abs(wheels.right_mps));
  if (fastest > body.wheel_limit_mps) {
    wheels.left_mps *= body.wheel_limit_mps / fastest;
    wheels.right_mps *= body.wheel_limit_mps / fastest;
  }
  return wheels;
}

Wheels turn_to(double bearing_rad, const Driving& driving, const Body& body) {
  return wheels_for(0.0, turn_rate(bearing_rad, driving), body);
}

Wheels steer_to(double bearing_rad, double speed_mps, const Driving& driving, const Body& body) {
  const double share = std::max(0.0, 1.0 - std::abs(bearing_rad) / driving.turn_in_place_rad);
  return wheels_for(speed_mps * share, turn_rate(bearing_rad, driving), body);
}

double free_ahead_m(const Surroundings& around, const Body& body, double bearing_rad) {
  return std::max(0.0, around.clearance_m(beside_the_body(around, body, bearing_rad, 0.0)) - body.ahead_m);
}

double free_alongside_m(const Surroundings& around, const Body& body, double bearing_rad) {
  const double ahead = body.ahead_m;
  return std::max(
      0.0, around.clearance_m(beside_the_body(around, body, bearing_rad, ahead - kTolerance_m)) - ahead);
}

double free_behind_m(const Surroundings& around, const Body& body) {
  const double behind = body.length_m - body.ahead_m;
  return std::max(
      0.0,
      around.clearance_m(beside_the_body(around, body, std::numbers::pi, behind - kTolerance_m)) - behind);
}

double turn_from_surfaces_rad(const Perception& seen, const Driving& driving, const Body& body) {
  const double wanted = 0.5 * body.width_m + driving.wall_room_m;
  const auto missing = [&](double bearing_rad) {
    const double clearance = seen.around.clearance_m({.bearing_rad = bearing_rad,
                                                      .half_width_m = driving.wall_window_m,
                                                      .surface_m = 0.0,
                                                      .surface_per_metre = 0.0});
    return std::max(0.0, 1.0 - clearance / wanted);
  };
  return driving.wall_turn_rad * (missing(-0.5 * std::numbers::pi) - missing(0.5 * std::numbers::pi));
}

double speed_for(double free_ahead_m, const Driving& driving) {
  // Rises from slow_mps at slow_below_m to the cruise speed at one and a half times that distance.
  const double share = std::clamp(free_ahead_m / driving.slow_below_m - 1.0, 0.0, 1.0);
  return driving.slow_mps + std::min(1.0, 2.0 * share) * (driving.cruise_mps - driving.slow_mps);
}

}  // namespace caravan::agent
