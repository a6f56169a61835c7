// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/manoeuvre.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot_agent/core/navigation/steering.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

constexpr double kFacing_rad = 0.1;
constexpr double kTooNearAhead_m = 0.3;
constexpr double kTooNearBehind_m = 0.08;
constexpr double kBackwards_mps = 0.3;
constexpr Time kMostForALeg = 4s;

}  // namespace

std::optional<Wheels> Performance::step(const Perception& seen, const Config& config) {
  while (current_ < legs_.size()) {
    if (!begun_) {
      begun_ = true;
      leg_began_at_ = seen.p_WB;
      leg_began_ = seen.now;
      leg_gives_up_ = seen.now + kMostForALeg;
    }
    std::optional<Wheels> wheels;
    if (seen.now < leg_gives_up_) {
      wheels = std::visit([&](const auto& leg) { return perform(leg, seen, config); }, legs_[current_]);
    }
    if (wheels) return wheels;
    skip();
  }
  return std::nullopt;
}

void Performance::skip() {
  ++current_;
  begun_ = false;
}

std::optional<Wheels> Performance::perform(const TurnTo& leg, const Perception& seen,
                                           const Config& config) const {
  const double error = wrapped(leg.yaw_WB_rad - seen.yaw_WB_rad);
  if (std::abs(error) < kFacing_rad) return std::nullopt;
  return turn_to(error, config);
}

std::optional<Wheels> Performance::perform(const Go& leg, const Perception& seen,
                                           const Config& config) const {
  if (seen.distance_to(leg_began_at_) >= std::abs(leg.distance_m)) return std::nullopt;
  if (leg.distance_m < 0.0) {
    if (free_behind_m(seen.around, config) < kTooNearBehind_m) return std::nullopt;
    return wheels_for(-kBackwards_mps, 0.0, config);
  }
  const double ahead = free_alongside_m(seen.around, config);
  if (ahead < kTooNearAhead_m) return std::nullopt;
  return wheels_for(
      std::max(config.driving.slow_mps, std::min(0.6 * config.driving.cruise_mps, speed_for(ahead, config))),
      0.0, config);
}

std::optional<Wheels> Performance::perform(const Veer& leg, const Perception& seen,
                                           const Config& config) const {
  if (seen.distance_to(leg_began_at_) >= leg.distance_m) return std::nullopt;
  if (free_alongside_m(seen.still, config) < kTooNearAhead_m) return std::nullopt;
  return steer_to(wrapped(leg.yaw_WB_rad - seen.yaw_WB_rad), leg.speed_mps, config);
}

std::optional<Wheels> Performance::perform(const Pause& leg, const Perception& seen, const Config&) const {
  if (seen.now - leg_began_ >= leg.duration) return std::nullopt;
  return Wheels{};
}

}  // namespace caravan::agent
