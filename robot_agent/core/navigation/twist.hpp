// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/settings.hpp"

namespace caravan::agent {

/// The velocity of a robot's base, in its own frame (REP-103: x forward).
struct Twist {
  double linear_mps = 0.0;     ///< forward positive
  double angular_radps = 0.0;  ///< counter-clockwise positive
};

[[nodiscard]] Twist twist_of(const Wheels& wheels, double track_m);

/// The twist after some seconds of a command that leads to `wanted`, with limited acceleration.
[[nodiscard]] Twist approaching(const Twist& now, const Twist& wanted, double seconds,
                                const Acceleration& limits);

}  // namespace caravan::agent
