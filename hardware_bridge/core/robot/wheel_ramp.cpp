// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/wheel_ramp.hpp"

#include <algorithm>

namespace caravan::bridge {
namespace {

constexpr double kBodyLimit_mps = 0.001 * WheelRamp::kTopSpeed_mmps;
constexpr double kTurnLimit_radps = WheelRamp::kTopTurn_degps * std::numbers::pi / 180.0;
constexpr double kHeadingGain = 2.0;  // rad/s for each radian off
constexpr double kHeadingTurn_radps = 1.0;
constexpr double kStallsAbove_mps = 0.05;
constexpr double kStallsBelow = 0.2;  // of what the wheel is told

void note_slow(std::optional<Time>& since, double told, double is, Time now) {
  const bool slow =
      std::abs(told) > kStallsAbove_mps && is * (told > 0.0 ? 1.0 : -1.0) < kStallsBelow * std::abs(told);
  if (!slow) {
    since.reset();
  } else if (!since) {
    since = now;
  }
}

}  // namespace

void WheelRamp::set_acceleration(int mmps2) {
  if (mmps2 > 0) acceleration_ = 0.001 * mmps2;
  if (mmps2 < 0) deceleration_ = -0.001 * mmps2;
}

void WheelRamp::set_max_speed(int mmps) {
  if (mmps > 0) most_mps_ = std::min(kBodyLimit_mps, 0.001 * mmps);
}

void WheelRamp::want_wheels(const arcos::WheelSpeeds& speeds) {
  const double left = std::clamp(0.001 * speeds.left_mmps, -most_mps_, most_mps_);
  const double right = std::clamp(0.001 * speeds.right_mmps, -most_mps_, most_mps_);
  ahead_goal_ = 0.5 * (left + right);
  turn_goal_ = std::clamp((right - left) / track_m_, -kTurnLimit_radps, kTurnLimit_radps);
  heading_rad_.reset();
}

void WheelRamp::want_speed(int mmps) { ahead_goal_ = std::clamp(0.001 * mmps, -most_mps_, most_mps_); }

void WheelRamp::want_turn_rate(int degps) {
  turn_goal_ = std::clamp(degps * std::numbers::pi / 180.0, -kTurnLimit_radps, kTurnLimit_radps);
  heading_rad_.reset();
}

void WheelRamp::want_stop() {
  ahead_goal_ = turn_goal_ = 0.0;
  heading_rad_.reset();
}

void WheelRamp::halt() {
  want_stop();
  speeds_ = {};
}

double WheelRamp::approach(double speed, double goal, double span_s) const {
  const bool slows = std::abs(goal) < std::abs(speed) || goal * speed < 0.0;
  const double most = span_s * (slows ? deceleration_ : acceleration_);
  return speed + std::clamp(goal - speed, -most, most);
}

WheelRamp::Speeds WheelRamp::at(Time now, double yaw_rad) {
  const double span_s = last_ ? std::clamp(seconds(now - *last_), 0.0, 0.2) : 0.0;
  last_ = now;
  double turn = turn_goal_;
  if (heading_rad_) {
    turn =
        std::clamp(kHeadingGain * wrapped(*heading_rad_ - yaw_rad), -kHeadingTurn_radps, kHeadingTurn_radps);
  }
  const double apart = 0.5 * turn * track_m_;
  speeds_.left_mps = approach(speeds_.left_mps, ahead_goal_ - apart, span_s);
  speeds_.right_mps = approach(speeds_.right_mps, ahead_goal_ + apart, span_s);
  return speeds_;
}

void WheelRamp::see(double left_mps, double right_mps, Time now) {
  note_slow(left_slow_, speeds_.left_mps, left_mps, now);
  note_slow(right_slow_, speeds_.right_mps, right_mps, now);
}

}  // namespace caravan::bridge
