// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/movement.hpp"

#include <algorithm>

namespace caravan::agent {
namespace {

// A little less than the motors give.
constexpr double kGains_mps2 = 3.0;
constexpr double kGains_radps2 = 12.0;

double towards(double now, double wanted, double most) { return now + std::clamp(wanted - now, -most, most); }

}  // namespace

Movement movement_of(const Wheels& wheels, const Config& config) {
  return {0.5 * (wheels.left_mps + wheels.right_mps), (wheels.right_mps - wheels.left_mps) / config.track_m};
}

Movement approaching(const Movement& now, const Movement& wanted, double seconds) {
  return {towards(now.speed_mps, wanted.speed_mps, seconds * kGains_mps2),
          towards(now.turn_radps, wanted.turn_radps, seconds * kGains_radps2)};
}

}  // namespace caravan::agent
