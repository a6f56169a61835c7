// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/touch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

// Steps over which a speed is computed. With the eight samples it defines the filter; it is no setting.
constexpr std::size_t kNow = 2;

}  // namespace

double TouchSensor::speed_mps(std::size_t wheel, std::size_t before, double wheel_radius_m) const {
  const Sample& late = samples_[before];
  const Sample& early = samples_[before + kNow];
  const double seconds = std::chrono::duration<double>(late.at - early.at).count();
  return wheel_radius_m * (late.angle_rad[wheel] - early.angle_rad[wheel]) / seconds;
}

bool TouchSensor::has_lost_speed(std::size_t wheel, double wheel_radius_m) const {
  const double sign = samples_[0].told_mps[wheel] < 0.0 ? -1.0 : 1.0;
  double kept = std::abs(samples_[0].told_mps[wheel]);
  for (const Sample& sample : samples_) kept = std::min(kept, sign * sample.told_mps[wheel]);
  if (kept < settings_.slowest_mps) return false;
  double reached = 0.0;
  for (std::size_t i = 1; i + kNow < samples_.size(); ++i) {
    reached = std::max(reached, sign * speed_mps(wheel, i, wheel_radius_m));
  }
  return reached >= settings_.reached_share * kept &&
         sign * speed_mps(wheel, 0, wheel_radius_m) < settings_.lost_share * kept;
}

bool TouchSensor::is_gapless() const {
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
    const Time gap = samples_[i].at - samples_[i + 1].at;
    if (gap <= Time{0} || gap > settings_.longest_gap) return false;
  }
  return true;
}

std::optional<Touch> TouchSensor::update(Time now, const Sensors& sensors, const Wheels& told,
                                         const Body& body) {
  std::shift_right(samples_.begin(), samples_.end(), 1);
  samples_[0] = {now, {sensors.left_wheel_rad, sensors.right_wheel_rad}, {told.left_mps, told.right_mps}};
  count_ = std::min(count_ + 1, samples_.size());
  if (count_ < samples_.size() || !is_gapless() || now - last_touch_ < settings_.pause) return std::nullopt;
  const bool left = has_lost_speed(0, body.wheel_radius_m);
  const bool right = has_lost_speed(1, body.wheel_radius_m);
  if (!left && !right) return std::nullopt;
  last_touch_ = now;
  const double rear = body.ahead_m - body.length_m;
  const double side = 0.5 * body.width_m;
  // The slowed wheel does not tell the side: a face at more than 45 degrees turns the robot away from it.
  if (told.left_mps * told.right_mps > 0.0) {
    const bool forward = told.left_mps > 0.0;
    return Touch{{forward ? body.ahead_m : rear, 0.0}, {forward ? 1.0 : -1.0, 0.0}, side};
  }
  // In a turn, contact at a rear corner pushes the base forward, contact at a front corner backward.
  const double pushed = speed_mps(0, 0, body.wheel_radius_m) + speed_mps(1, 0, body.wheel_radius_m) -
                        told.left_mps - told.right_mps;
  if (std::abs(pushed) < 2.0 * settings_.pushed_mps) return std::nullopt;
  const double to_the_left = (told.right_mps > told.left_mps) == (pushed < 0.0) ? 1.0 : -1.0;
  return Touch{{pushed > 0.0 ? rear : body.ahead_m, to_the_left * side}, {0.0, to_the_left}};
}

}  // namespace caravan::agent
