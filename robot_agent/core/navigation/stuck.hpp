// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Notices that the wheels are told to move and the robot does not: it touches something that its sonars do
/// not see (oblique walls and corners return no echo), or its wheels slip.
class StuckMonitor {
 public:
  /// To be called in every step with what was commanded in the step before.
  /// @return true when the robot has not moved although it should have; it then starts afresh
  bool update(const Perception& seen, const Wheels& commanded, const Recovery& recovery, double track_m);
  /// Forgets what was: the robot was not driving.
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
