// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of the task. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// What is to be carried where. `destination` is read by sees_destination() only: sight of it is simulated by
/// distance, as in the paper.
struct Task {
  Point source{0.0, 0.0};
  Point destination{0.0, 0.0};
  double service_radius_m = 1.5;                           ///< within it items change hands
  double arrival_radius_m = 1.0;                           ///< within it the robot turns back
  Time gripper_patience = std::chrono::milliseconds{300};  ///< to hold, or not to, once it was told

  bool operator==(const Task&) const = default;
};

}  // namespace caravan::agent
