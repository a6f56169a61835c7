// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Notices what is lower than the sonars before the robot touches it: it returns an echo from a distance,
/// where it lies in the lower part of the cone, and none from nearer by.
///
/// Only the two sonars that look straight ahead count, while the robot drives straight at something that both
/// see: what is as high as they are cannot leave both cones then.
class VanishingEcho {
 public:
  explicit VanishingEcho(const EchoLoss& settings) : settings_{settings} {}

  /// To be called in every step.
  /// @return how far ahead of the base the thing begins; once
  [[nodiscard]] std::optional<double> update(const Perception& seen);

 private:
  struct Sight {
    Time at{0};
    Point p_WB{0.0, 0.0};
    double yaw_WB_rad = 0.0;
    double ahead_m = 0.0;
  };
  EchoLoss settings_;
  std::optional<Sight> first_;  // of an approach in one direction
  Sight last_;
};

}  // namespace caravan::agent
