// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Detects a robot that does not move despite commands: it touches something that its sonars do not see
/// (oblique walls and corners return no echo), or its wheels slip.
class StuckMonitor {
 public:
  /// Call in every step with the command of the previous step.
  /// @return true when the robot is stuck; the measurement then starts anew
  bool update(const Perception& seen, const Wheels& commanded, const Recovery& recovery, double track_m);
  /// Restarts the measurement: the robot was not driving.
  void reset() { anchored_ = false; }

 private:
  void anchor(const Perception& seen);
  bool anchored_ = false;
  Point p_WB_{0.0, 0.0};
  double yaw_WB_rad_ = 0.0;
  Time last_{0};
  double commanded_m_ = 0.0;
  double commanded_rad_ = 0.0;
};

}  // namespace caravan::agent
