// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// How a robot's base moves.
struct Movement {
  double speed_mps = 0.0;   ///< forward positive
  double turn_radps = 0.0;  ///< counter-clockwise positive
};

[[nodiscard]] Movement movement_of(const Wheels& wheels, const Config& config);

/// How it moves a little later when the wheels are told to bring it to `wanted`: motors and mass take their
/// time.
[[nodiscard]] Movement approaching(const Movement& now, const Movement& wanted, double seconds);

}  // namespace caravan::agent
