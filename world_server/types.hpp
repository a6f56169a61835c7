// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/pure/robot_model.hpp"

namespace caravan::world {

/// Simulated time since the session began.
using Time = std::chrono::nanoseconds;

using robot_model::kSonarCount;

/// True pose of a robot's base (on the axle, on the floor) in frame W.
struct Pose {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< counter-clockwise from east, in (-pi, pi]
};

/// A robot's command for one step. Already finite and within the wheel limit (see sanitise()).
struct Command {
  double left_mps = 0.0;  ///< rim speeds
  double right_mps = 0.0;
  bool gripper_closed = false;
};

/// A contact episode that began in this step; a new one for the same pair only after 1 s apart.
struct ContactEpisode {
  std::uint32_t robot = 0;
  std::uint32_t other = 0;  ///< the other robot, 0: something static
};

struct ItemEvent {
  enum class Kind : std::uint8_t { kPickUp, kDelivery };
  Kind kind = Kind::kPickUp;
  std::uint32_t robot = 0;
};

}  // namespace caravan::world
