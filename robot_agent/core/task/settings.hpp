// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of the task. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// What is to be carried where. `destination` is read by sees_destination() only: sight of it is simulated by
/// distance, as in the paper.
struct Task {
  Point source{0.0, 0.0};
  Point destination{0.0, 0.0};
  double service_radius_m = 1.5;  ///< within it items change hands
  double arrival_radius_m = 1.0;  ///< within it the robot turns back
  double crowded_m = 2.5;         ///< with another robot this near ahead, it does within service_radius_m
  Time gripper_patience = std::chrono::milliseconds{300};  ///< to hold, or not to, once it was told

  bool operator==(const Task&) const = default;
};

/// A robot with a path that makes no progress along it explores for a while.
struct Progress {
  double least_m = 0.5;                            ///< the way to the end becomes this much shorter
  Time timeout = std::chrono::seconds{8};          ///< in this time
  double wander_m = 2.5;                           ///< exploring ends this far from where it began,
  std::uint32_t wander_doublings = 3;              ///< twice as far each time, up to so many times,
  Time wander_again = std::chrono::seconds{60};    ///< when it began again within this time,
  Time wander_timeout = std::chrono::seconds{20};  ///< and at the latest after this

  bool operator==(const Progress&) const = default;
};

}  // namespace caravan::agent
