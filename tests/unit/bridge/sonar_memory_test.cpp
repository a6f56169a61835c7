// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "hardware_bridge/core/arcos/sonar_memory.hpp"

namespace caravan::bridge {
namespace {

using arcos::Sip;
using arcos::SonarMemory;
using namespace std::chrono_literals;

TEST(SonarMemory, KeepsAReadingAndItsAgeUntilTheNext) {
  SonarMemory memory;
  memory.hear(std::array<Sip::Sonar, 2>{{{3, 1500}, {4, 700}}}, 1s);
  memory.hear(std::array<Sip::Sonar, 1>{{{4, 650}}}, 1100ms);
  EXPECT_DOUBLE_EQ(memory.ranges_m()[3], 1.5);
  EXPECT_DOUBLE_EQ(memory.ranges_m()[4], 0.65);
  EXPECT_DOUBLE_EQ(memory.ages_s(1200ms)[3], 0.2);
  EXPECT_DOUBLE_EQ(memory.ages_s(1200ms)[4], 0.1);
}

TEST(SonarMemory, NoEchoIsInfinite) {
  SonarMemory memory;
  memory.hear(std::array<Sip::Sonar, 2>{{{0, 4999}, {1, 5000}}}, 0s);
  EXPECT_DOUBLE_EQ(memory.ranges_m()[0], 4.999);
  EXPECT_TRUE(std::isinf(memory.ranges_m()[1]));
}

TEST(SonarMemory, WhatHasNotFiredYetIsNotKnownAndForEverOld) {
  SonarMemory memory;
  EXPECT_TRUE(std::isnan(memory.ranges_m()[7]));
  EXPECT_TRUE(std::isinf(memory.ages_s(5s)[7]));
  memory.hear(std::array<Sip::Sonar, 1>{{{7, 100}}}, 0s);
  memory.forget();
  EXPECT_TRUE(std::isnan(memory.ranges_m()[7]));
}

TEST(SonarMemory, IgnoresTransducersThatTheRobotDoesNotHave) {
  SonarMemory memory;
  memory.hear(std::array<Sip::Sonar, 1>{{{200, 100}}}, 0s);
  for (const double range : memory.ranges_m()) EXPECT_TRUE(std::isnan(range));
}

}  // namespace
}  // namespace caravan::bridge
