// SPDX-License-Identifier: Apache-2.0
#include "world_server/barrier/pace.hpp"

#include <gtest/gtest.h>

#include "world_server/barrier/step_inputs.hpp"

namespace caravan::world {
namespace {

using namespace std::chrono_literals;

constexpr Wall kStart{100s};

TEST(Pace, MakesStepsDueOnePeriodApart) {
  Pace pace{32ms};
  pace.start(kStart);
  pace.open(kStart, 1.0);
  EXPECT_FALSE(pace.is_due(kStart + 31ms, 1.0));
  EXPECT_TRUE(pace.is_due(kStart + 32ms, 1.0));
  pace.open(kStart + 40ms, 1.0);
  EXPECT_EQ(pace.due(), kStart + 64ms) << "8 ms late are made up for";
}

TEST(Pace, DividesThePeriodByTheSpeed) {
  Pace pace{32ms};
  pace.start(kStart);
  pace.open(kStart, 4.0);
  EXPECT_EQ(pace.due(), kStart + 8ms);
}

TEST(Pace, DoesNotMakeUpForALongDelay) {
  Pace pace{32ms};
  pace.start(kStart);
  pace.open(kStart + 5s, 1.0);
  EXPECT_EQ(pace.due(), kStart + 5s + 32ms);
}

TEST(Pace, HasEveryStepDueAtSpeedZero) {
  Pace pace{32ms};
  pace.start(kStart);
  pace.open(kStart, 0.0);
  EXPECT_TRUE(pace.is_due(kStart, 0.0));
}

TEST(Pace, OfASlowWorldCountsAtOnceWhenTheSpeedIsRaisedAndNotBeforeWhenItIsLowered) {
  Pace pace{32ms};
  pace.start(kStart);
  pace.open(kStart, 0.001);
  EXPECT_EQ(pace.due(), kStart + 32s);
  pace.change(kStart + 1s, 1.0);
  EXPECT_EQ(pace.due(), kStart + 1s + 32ms);
  pace.change(kStart + 1s, 0.001);
  EXPECT_EQ(pace.due(), kStart + 1s + 32ms);
}

TEST(StepInputs, AreUsedUpByTheStepUnlessCommandsHold) {
  StepInputs inputs{2};
  inputs.command(1, {.left_mps = 0.5}, 0s);
  inputs.reporting = {1};
  inputs.moved(true);
  EXPECT_TRUE(inputs.commands[0]);
  EXPECT_EQ(inputs.reported, std::vector<std::uint32_t>{1});
  inputs.moved(false);
  EXPECT_FALSE(inputs.commands[0]);
  EXPECT_TRUE(inputs.reported.empty());
}

TEST(StepInputs, DropCommandsThatAreTooOld) {
  StepInputs inputs{2};
  inputs.command(1, {.left_mps = 0.5}, 1s);
  inputs.command(2, {.left_mps = 0.5}, 2s);
  inputs.drop_older(2600ms, 600ms);
  EXPECT_FALSE(inputs.commands[0]);
  EXPECT_TRUE(inputs.commands[1]);
}

}  // namespace
}  // namespace caravan::world
