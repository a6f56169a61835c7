// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Detects an obstacle that is lower than the sonars before the robot touches it: it returns an echo from a
/// distance, where it is in the lower part of the cone, and none from close by.
///
/// Uses only the two forward sonars, while the robot drives straight at something that both see: an obstacle
/// as high as the sonars cannot leave both cones then.
class VanishingEcho {
 public:
  explicit VanishingEcho(const EchoLoss& settings) : settings_{settings} {}

  /// Call in every step.
  /// @return distance of the obstacle ahead of the base, metres; once for each obstacle
  [[nodiscard]] std::optional<double> update(const Perception& seen);

 private:
  struct Sight {
    Time at{0};
    Point p_WB{0.0, 0.0};
    double yaw_WB_rad = 0.0;
    double ahead_m = 0.0;
  };
  EchoLoss settings_;
  std::optional<Sight> first_;  // beginning of an approach in one direction
  Sight last_;
};

}  // namespace caravan::agent
