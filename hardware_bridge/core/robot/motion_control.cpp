// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/motion_control.hpp"

#include <algorithm>
#include <utility>

namespace caravan::bridge {
namespace {

constexpr double kGain = 5.0;  // 1/s; close to the goal the speed is proportional to the distance

double clamped(double value, double most) { return std::clamp(value, -most, most); }

/// The speed from which `deceleration` comes to rest within the remaining distance.
double speed_towards(double left, double most, double deceleration) {
  const double braking = std::sqrt(2.0 * deceleration * std::abs(left));
  return std::copysign(std::min({most, braking, kGain * std::abs(left)}), left);
}

double approached(double speed, double goal, double acceleration, double deceleration, double span_s) {
  const bool slows = std::abs(goal) < std::abs(speed) || goal * speed < 0.0;
  return speed + clamped(goal - speed, span_s * (slows ? deceleration : acceleration));
}

}  // namespace

void MotionControl::want_ahead(const Setpoint& setpoint) {
  if (std::exchange(by_wheels_, false)) turn_ = 0.0;
  ahead_ = setpoint;
}

void MotionControl::want_turn(const Setpoint& setpoint) {
  if (std::exchange(by_wheels_, false)) ahead_ = 0.0;
  turn_ = setpoint;
}

void MotionControl::want_wheels(double left_mps, double right_mps) {
  by_wheels_ = true;
  ahead_ = 0.5 * (left_mps + right_mps);
  turn_ = (right_mps - left_mps) / track_m_;
}

void MotionControl::want_stop() { ahead_ = turn_ = 0.0; }

void MotionControl::halt() {
  want_stop();
  ahead_mps_ = turn_radps_ = 0.0;
}

void MotionControl::turn_origin(double by_rad) {
  if (auto* heading = std::get_if<Until>(&turn_)) heading->value = wrapped(heading->value - by_rad);
}

std::optional<double> MotionControl::heading_rad() const {
  const auto* heading = std::get_if<Until>(&turn_);
  return heading == nullptr ? std::nullopt : std::optional{heading->value};
}

double MotionControl::wanted_ahead_mps(const Place& place) const {
  if (const auto* end = std::get_if<Until>(&ahead_)) {
    return speed_towards(end->value - place.travelled_m, limits_.speed_mps, limits_.deceleration_mps2);
  }
  return clamped(std::get<double>(ahead_), limits_.speed_mps);
}

double MotionControl::wanted_turn_radps(const Place& place) const {
  if (const auto* end = std::get_if<Until>(&turn_)) {
    return speed_towards(wrapped(end->value - place.yaw_rad), limits_.turn_radps,
                         limits_.turn_deceleration_radps2);
  }
  return clamped(std::get<double>(turn_), limits_.turn_radps);
}

MotionControl::Speeds MotionControl::at(Time now, const Place& place) {
  const double span_s = last_ ? std::clamp(seconds(now - *last_), 0.0, 0.2) : 0.0;
  last_ = now;
  ahead_mps_ = approached(ahead_mps_, held_ ? 0.0 : wanted_ahead_mps(place), limits_.acceleration_mps2,
                          limits_.deceleration_mps2, span_s);
  turn_radps_ = approached(turn_radps_, held_ ? 0.0 : wanted_turn_radps(place),
                           limits_.turn_acceleration_radps2, limits_.turn_deceleration_radps2, span_s);
  const double apart = 0.5 * turn_radps_ * track_m_;
  return {clamped(ahead_mps_ - apart, limits_.wheel_mps), clamped(ahead_mps_ + apart, limits_.wheel_mps)};
}

}  // namespace caravan::bridge
