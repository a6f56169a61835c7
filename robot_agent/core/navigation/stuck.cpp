// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/stuck.hpp"

#include <chrono>
#include <cmath>

namespace caravan::agent {
bool StuckMonitor::update(const Perception& seen, const Wheels& commanded, const Recovery& recovery,
                          double track_m) {
  if (!anchored_) {
    anchor(seen);
    return false;
  }
  const double dt = std::chrono::duration<double>(seen.now - last_).count();
  last_ = seen.now;
  commanded_m_ += dt * 0.5 * (commanded.left_mps + commanded.right_mps);
  commanded_rad_ += dt * (commanded.right_mps - commanded.left_mps) / track_m;
  if (seen.distance_to(p_WB_) > recovery.stuck_moved_m ||
      std::abs(wrapped(seen.yaw_WB_rad - yaw_WB_rad_)) > recovery.stuck_turned_rad) {
    anchor(seen);
    return false;
  }
  if (std::abs(commanded_m_) < recovery.stuck_commanded_m &&
      std::abs(commanded_rad_) < recovery.stuck_commanded_rad)
    return false;
  anchor(seen);
  return true;
}

void StuckMonitor::anchor(const Perception& seen) {
  anchored_ = true;
  p_WB_ = seen.p_WB;
  yaw_WB_rad_ = seen.yaw_WB_rad;
  last_ = seen.now;
  commanded_m_ = 0.0;
  commanded_rad_ = 0.0;
}

}  // namespace caravan::agent
