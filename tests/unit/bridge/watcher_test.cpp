// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/watcher.hpp"

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

std::string told(Watcher& watcher, const Sip& sip) {
  std::string text;
  for (const Notice& notice : watcher.watch(sip)) text += notice.text + "; ";
  return text;
}

TEST(Watcher, SaysNothingOfAHealthyRobot) {
  Watcher watcher{11.5};
  EXPECT_THAT(told(watcher, healthy()), IsEmpty());
}

TEST(Watcher, TellsEachChangeOnce) {
  Watcher watcher{11.5};
  Sip sip = healthy();
  sip.flags = 0;
  EXPECT_THAT(told(watcher, sip), HasSubstr("motors are disabled"));
  EXPECT_THAT(told(watcher, sip), IsEmpty());
  EXPECT_THAT(told(watcher, healthy()), HasSubstr("motors are enabled"));
  sip = healthy();
  sip.stall_and_bumpers = arcos::kLeftStall;
  EXPECT_THAT(told(watcher, sip), HasSubstr("left wheel stalls"));
  sip.stall_and_bumpers = arcos::kRightStall;
  EXPECT_THAT(told(watcher, sip), HasSubstr("right wheel stalls"));
}

TEST(Watcher, NamesTheBumpersThatArePressedAndTellsEachChangeOnce) {
  Watcher watcher{11.5};
  Sip sip = healthy();
  sip.stall_and_bumpers = 1U << 2U | 1U << 9U;
  EXPECT_THAT(told(watcher, sip),
              AllOf(HasSubstr("bumpers pressed"), HasSubstr("front 1"), HasSubstr("rear 2")));
  EXPECT_THAT(told(watcher, sip), IsEmpty());
  EXPECT_THAT(told(watcher, healthy()), HasSubstr("bumpers are free"));
}

TEST(Watcher, ABatteryAtTheLimitIsToldOnce) {
  Watcher watcher{11.5};
  Sip sip = healthy();
  sip.battery_fine_dv = std::uint16_t{114};
  EXPECT_THAT(told(watcher, sip), HasSubstr("battery low: 11.4 V"));
  sip.battery_fine_dv = std::uint16_t{116};
  EXPECT_THAT(told(watcher, sip), IsEmpty());
  sip.battery_fine_dv = std::uint16_t{120};
  EXPECT_THAT(told(watcher, sip), HasSubstr("recovered"));
}

}  // namespace
}  // namespace caravan::bridge
