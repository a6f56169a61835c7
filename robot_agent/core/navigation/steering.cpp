// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/steering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caravan::agent {
namespace {

constexpr double kTurnGain = 3.0;          // 1/s
constexpr double kMostTurn_radps = 2.5;    // rad/s
constexpr double kTurnsInPlace_rad = 0.8;  // bearings beyond it
constexpr double kLean_rad = 0.5;
constexpr double kWantedBeside_m = 0.3;  // free space on either side that a driving robot tries to keep
constexpr double kBesideBody_m = 0.04;   // on either side of the body
constexpr double kReaches_m = 0.01;      // what reaches less beyond the body's end is beside it

double turn_rate(double bearing_rad) {
  return std::clamp(kTurnGain * bearing_rad, -kMostTurn_radps, kMostTurn_radps);
}

Corridor beside_the_body(const Surroundings& around, const Body& body, double bearing_rad, double beyond_m) {
  return {.bearing_rad = bearing_rad,
          .half_width_m = 0.5 * body.width_m + kBesideBody_m,
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

Wheels turn_to(double bearing_rad, const Body& body) { return wheels_for(0.0, turn_rate(bearing_rad), body); }

Wheels steer_to(double bearing_rad, double speed_mps, const Body& body) {
  const double share = std::max(0.0, 1.0 - std::abs(bearing_rad) / kTurnsInPlace_rad);
  return wheels_for(speed_mps * share, turn_rate(bearing_rad), body);
}

double free_ahead_m(const Surroundings& around, const Body& body, double bearing_rad) {
  return std::max(0.0, around.clearance_m(beside_the_body(around, body, bearing_rad, 0.0)) - body.ahead_m);
}

double free_alongside_m(const Surroundings& around, const Body& body, double bearing_rad) {
  const double ahead = body.ahead_m;
  return std::max(0.0,
                  around.clearance_m(beside_the_body(around, body, bearing_rad, ahead - kReaches_m)) - ahead);
}

double free_behind_m(const Surroundings& around, const Body& body) {
  const double behind = body.length_m - body.ahead_m;
  return std::max(
      0.0, around.clearance_m(beside_the_body(around, body, std::numbers::pi, behind - kReaches_m)) - behind);
}

double turn_from_surfaces_rad(const Perception& seen, const Body& body) {
  const double wanted = 0.5 * body.width_m + kWantedBeside_m;
  const auto lack = [&](double bearing_rad) {
    const double clearance = seen.around.clearance_m(
        {.bearing_rad = bearing_rad, .half_width_m = 0.3, .surface_m = 0.0, .surface_per_metre = 0.0});
    return std::max(0.0, 1.0 - clearance / wanted);
  };
  return kLean_rad * (lack(-0.5 * std::numbers::pi) - lack(0.5 * std::numbers::pi));
}

double speed_for(double free_ahead_m, const Driving& driving) {
  const double share = std::clamp(free_ahead_m / driving.slow_below_m - 1.0, 0.0, 1.0);
  return driving.slow_mps + std::min(1.0, 2.0 * share) * (driving.cruise_mps - driving.slow_mps);
}

}  // namespace caravan::agent
