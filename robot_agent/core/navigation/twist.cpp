// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/twist.hpp"

#include <algorithm>

namespace caravan::agent {
namespace {

double towards(double now, double wanted, double most) { return now + std::clamp(wanted - now, -most, most); }

}  // namespace

Twist twist_of(const Wheels& wheels, double track_m) {
  return {0.5 * (wheels.left_mps + wheels.right_mps), (wheels.right_mps - wheels.left_mps) / track_m};
}

Twist approaching(const Twist& now, const Twist& wanted, double seconds, const Acceleration& limits) {
  return {towards(now.linear_mps, wanted.linear_mps, seconds * limits.linear_mps2),
          towards(now.angular_radps, wanted.angular_radps, seconds * limits.angular_radps2)};
}

}  // namespace caravan::agent
