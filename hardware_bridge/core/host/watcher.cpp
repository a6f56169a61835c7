// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/watcher.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace caravan::bridge {
namespace {

constexpr double kRecovered_v = 0.3;  // above the limit, so that a battery at the limit is told once

std::string in_volts(double volts) {
  const long tenths = std::lround(10.0 * volts);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " V";
}

}  // namespace

std::vector<Notice> Watcher::watch(const arcos::Sip& sip) {
  std::vector<Notice> notices;
  const auto tell = [&](bool& known, bool now, const std::string& begins, const std::string& ends) {
    if (known == now) return false;
    known = now;
    notices.push_back({now ? Notice::Weight::kWarning : Notice::Weight::kInfo, now ? begins : ends});
    return true;
  };
  if (tell(stop_pressed_, (sip.flags & arcos::kStopPressed) != 0, "emergency stop pressed",
           "emergency stop released")) {
    stop_released_ = !stop_pressed_;
  }
  bool motors_off = !motors_on_;
  tell(motors_off, (sip.flags & arcos::kMotorsOn) == 0,
       "motors are disabled: press the robot's MOTORS button", "motors are enabled");
  motors_on_ = !motors_off;
  tell(left_stalls_, (sip.stall_and_bumpers & arcos::kLeftStall) != 0, "left wheel stalls",
       "left wheel turns again");
  tell(right_stalls_, (sip.stall_and_bumpers & arcos::kRightStall) != 0, "right wheel stalls",
       "right wheel turns again");
  battery_v_ = 0.1 * (sip.battery_fine_dv ? *sip.battery_fine_dv : sip.battery_dv);
  const double limit = low_battery_v_ + (battery_low_ ? kRecovered_v : 0.0);
  tell(battery_low_, battery_v_ < limit, "battery low: " + in_volts(battery_v_),
       "battery recovered: " + in_volts(battery_v_));
  return notices;
}

bool Watcher::take_stop_released() { return std::exchange(stop_released_, false); }

}  // namespace caravan::bridge
