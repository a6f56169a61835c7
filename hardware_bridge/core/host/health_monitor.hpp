// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/host/notice.hpp"

namespace caravan::bridge {

/// Reports changes in the health of a robot, from its SIPs. StopLatch handles the emergency stop.
class HealthMonitor {
 public:
  explicit HealthMonitor(double low_battery_v) : low_battery_v_{low_battery_v} {}

  [[nodiscard]] std::vector<Notice> watch(const arcos::Sip& sip);
  [[nodiscard]] double battery_v() const { return battery_v_; }

 private:
  double low_battery_v_;
  double battery_v_ = 0.0;
  bool motors_on_ = true;  // initially true, so that motors that are off are reported
  bool left_stalls_ = false;
  bool right_stalls_ = false;
  bool battery_low_ = false;
  std::uint16_t bumpers_ = 0;
};

}  // namespace caravan::bridge
