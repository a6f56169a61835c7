// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/health_monitor.hpp"

#include <cmath>
#include <string>

namespace caravan::bridge {
namespace {

constexpr double kRecovered_v = 0.3;  // hysteresis: a battery at the limit is reported once

std::string in_volts(double volts) {
  const long tenths = std::lround(10.0 * volts);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " V";
}

constexpr std::uint16_t kStalls = arcos::kLeftStall | arcos::kRightStall;

std::string named(std::uint16_t bumpers) {
  std::string text;
  const auto add = [&](const char* which, unsigned shift) {
    for (unsigned i = 0; i < arcos::kMostBumpers; ++i) {
      if ((bumpers >> (shift + i) & 1U) != 0) text += which + std::to_string(i + 1);
    }
  };
  add(" front ", arcos::kFrontBumperShift);
  add(" rear ", arcos::kRearBumperShift);
  return text;
}

}  // namespace

std::vector<Notice> HealthMonitor::watch(const arcos::Sip& sip) {
  std::vector<Notice> notices;
  const auto tell = [&](bool& known, bool now, const std::string& begins, const std::string& ends) {
    if (known == now) return;
    known = now;
    notices.push_back({now ? Notice::Weight::kWarning : Notice::Weight::kInfo, now ? begins : ends, ends});
  };
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
  const auto bumpers = static_cast<std::uint16_t>(sip.stall_and_bumpers & ~kStalls);
  if (bumpers != bumpers_) {
    notices.push_back({bumpers != 0 ? Notice::Weight::kWarning : Notice::Weight::kInfo,
                       bumpers != 0 ? "bumpers pressed:" + named(bumpers) : "bumpers are free", "bumpers"});
  }
  bumpers_ = bumpers;
  return notices;
}

}  // namespace caravan::bridge
