// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/health_monitor.hpp"

namespace caravan::bridge {
namespace {

using arcos::Sip;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Sip healthy() {
  Sip sip;
  sip.flags = arcos::kMotorsOn;
  sip.battery_dv = 126;
  return sip;
}

std::string told(HealthMonitor& monitor, const Sip& sip) {
  std::string text;
  for (const Notice& notice : monitor.watch(sip)) text += notice.text + "; ";
  return text;
}

TEST(HealthMonitor, SaysNothingOfAHealthyRobot) {
  HealthMonitor monitor{11.5};
  EXPECT_THAT(told(monitor, healthy()), IsEmpty());
}

TEST(HealthMonitor, TellsEachChangeOnce) {
  HealthMonitor monitor{11.5};
  Sip sip = healthy();
  sip.flags = 0;
  EXPECT_THAT(told(monitor, sip), HasSubstr("motors are disabled"));
  EXPECT_THAT(told(monitor, sip), IsEmpty());
  EXPECT_THAT(told(monitor, healthy()), HasSubstr("motors are enabled"));
  sip = healthy();
  sip.stall_and_bumpers = arcos::kLeftStall;
  EXPECT_THAT(told(monitor, sip), HasSubstr("left wheel stalls"));
  sip.stall_and_bumpers = arcos::kRightStall;
  EXPECT_THAT(told(monitor, sip), HasSubstr("right wheel stalls"));
}

TEST(HealthMonitor, NamesTheBumpersThatArePressedAndTellsEachChangeOnce) {
  HealthMonitor monitor{11.5};
  Sip sip = healthy();
  sip.stall_and_bumpers = 1U << 2U | 1U << 9U;
  EXPECT_THAT(told(monitor, sip),
              AllOf(HasSubstr("bumpers pressed"), HasSubstr("front 1"), HasSubstr("rear 2")));
  EXPECT_THAT(told(monitor, sip), IsEmpty());
  EXPECT_THAT(told(monitor, healthy()), HasSubstr("bumpers are free"));
}

TEST(HealthMonitor, ABatteryAtTheLimitIsToldOnce) {
  HealthMonitor monitor{11.5};
  Sip sip = healthy();
  sip.battery_fine_dv = std::uint16_t{114};
  EXPECT_THAT(told(monitor, sip), HasSubstr("battery low: 11.4 V"));
  sip.battery_fine_dv = std::uint16_t{116};
  EXPECT_THAT(told(monitor, sip), IsEmpty());
  sip.battery_fine_dv = std::uint16_t{120};
  EXPECT_THAT(told(monitor, sip), HasSubstr("recovered"));
}

}  // namespace
}  // namespace caravan::bridge
