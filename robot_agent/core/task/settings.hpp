// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/types.hpp"

/// Parameters of the task. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// The transport task. sees_destination() simulates sight of `destination` by distance, as in the paper.
struct Task {
  Point source{0.0, 0.0};
  Point destination{0.0, 0.0};
  double service_radius_m = 1.5;  ///< items are picked up and delivered within it
  double arrival_radius_m = 1.0;  ///< the robot turns back within it
  double crowded_m = 2.5;         ///< with another robot this near ahead, service_radius_m suffices
  Time gripper_patience = std::chrono::milliseconds{300};  ///< for the gripper to follow a command

  bool operator==(const Task&) const = default;
};

/// A robot that makes no progress along its path explores for a while.
struct Progress {
  double least_m = 0.5;                            ///< the remaining path becomes shorter by this
  Time timeout = std::chrono::seconds{8};          ///< within this time
  double wander_m = 2.5;                           ///< distance from its beginning at which exploration ends
  std::uint32_t wander_doublings = 3;              ///< how often it is doubled at most
  Time wander_again = std::chrono::seconds{60};    ///< within which another exploration doubles it
  Time wander_timeout = std::chrono::seconds{20};  ///< longest exploration

  bool operator==(const Progress&) const = default;
};

}  // namespace caravan::agent
