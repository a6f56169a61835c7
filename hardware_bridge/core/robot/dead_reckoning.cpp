// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/dead_reckoning.hpp"

#include <algorithm>

namespace caravan::bridge {
namespace {

std::uint16_t wrapped_counts(double value, int wraps_at) {
  const auto counts = static_cast<long long>(std::floor(value)) % wraps_at;
  return static_cast<std::uint16_t>(counts < 0 ? counts + wraps_at : counts);
}

std::int16_t in_mmps(double speed_mps) {
  return static_cast<std::int16_t>(std::lround(std::clamp(1000.0 * speed_mps, -32767.0, 32767.0)));
}

}  // namespace

std::int16_t heading_counts(double yaw_rad) {
  const double turns = yaw_rad / (2.0 * std::numbers::pi);
  return static_cast<std::int16_t>(
      wrapped_counts(turns * arcos::kHeadingCounts + 0.5, arcos::kHeadingCounts));
}

void DeadReckoning::turn(double left_wheel_rad, double right_wheel_rad, Time now) {
  const Seen seen{wheel_radius_m_ * left_wheel_rad, wheel_radius_m_ * right_wheel_rad, now};
  if (last_) {
    const double left = seen.left_m - last_->left_m;
    const double right = seen.right_m - last_->right_m;
    const double turned = (right - left) / track_m_;
    const double half_way = yaw_rad_ + 0.5 * turned;
    x_m_ += 0.5 * (left + right) * std::cos(half_way);
    y_m_ += 0.5 * (left + right) * std::sin(half_way);
    yaw_rad_ = wrapped(yaw_rad_ + turned);
    left_m_ += left;
    right_m_ += right;
    const double span = seconds(now - last_->at);
    if (span > 0.0) {
      left_mps_ = left / span;
      right_mps_ = right / span;
    }
  }
  last_ = seen;
}

void DeadReckoning::write(arcos::Sip& sip) const {
  sip.x = wrapped_counts(x_m_ / factors_.position_m, 1 << 15);
  sip.y = wrapped_counts(y_m_ / factors_.position_m, 1 << 15);
  sip.heading = heading_counts(yaw_rad_);
  sip.left_mmps = in_mmps(left_mps_);
  sip.right_mmps = in_mmps(right_mps_);
}

}  // namespace caravan::bridge
