// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>

#include "experiment/trace/compare.hpp"
#include "experiment/trace/steps.hpp"
#include "experiment/trace/trace_reader.hpp"
#include "runtime/controller/step_trace.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

using testing::ElementsAre;

caravan::Inputs some_inputs() {
  caravan::Inputs inputs;
  inputs.now = caravan::Time{64'000'000};
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    inputs.sensors.sonar_range_m[i] = 0.5 + static_cast<double>(i);
    inputs.sensors.sonar_age_s[i] = 0.01 * static_cast<double>(i);
  }
  inputs.sensors.sonar_range_m[3] = std::numeric_limits<double>::infinity();
  inputs.sensors.sonar_range_m[4] = std::numeric_limits<double>::quiet_NaN();
  inputs.sensors.position = {1.25, -0.0};
  inputs.sensors.yaw_rad = -3.0;
  inputs.sensors.left_wheel_rad = 100.5;
  inputs.sensors.right_wheel_rad = -0.1;
  inputs.sensors.holding = true;
  inputs.heard = {{7, {1, 2, 255}, -60.5}, {0, {}, std::numeric_limits<double>::quiet_NaN()}};
  return inputs;
}

caravan::Outputs some_outputs() {
  return {.left_mps = 0.25,
          .right_mps = -0.5,
          .gripper_closed = true,
          .tuned_channel = 9,
          .frames = {{0, {1, 2}}, {9, {}}},
          .report = {}};
}

TEST(RobotTrace, GivesBackWhatAControllerWasGivenAndAnsweredBitForBit) {
  const Folder folder;
  const caravan::Inputs inputs = some_inputs();
  {
    runtime::StepTrace trace{folder.path(), 3};
    trace.ask(inputs);
    trace.answer(some_outputs());
  }
  TraceReader reader{runtime::robot_trace_in(folder.path(), 3), runtime::kRobotTrace};
  EXPECT_EQ(reader.number(), 3U);
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(reader.next(bytes));
  const caravan::Inputs read = read_inputs(bytes);
  ASSERT_TRUE(reader.next(bytes));
  const caravan::Outputs answered = read_outputs(bytes);
  EXPECT_FALSE(reader.next(bytes));

  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  EXPECT_EQ(read.now, inputs.now);
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    EXPECT_EQ(bits(read.sensors.sonar_range_m[i]), bits(inputs.sensors.sonar_range_m[i])) << i;
    EXPECT_EQ(bits(read.sensors.sonar_age_s[i]), bits(inputs.sensors.sonar_age_s[i])) << i;
  }
  EXPECT_EQ(read.sensors.position.x_m, 1.25);
  EXPECT_EQ(bits(read.sensors.position.y_m), bits(-0.0));
  EXPECT_EQ(read.sensors.yaw_rad, -3.0);
  EXPECT_EQ(read.sensors.left_wheel_rad, 100.5);
  EXPECT_EQ(read.sensors.right_wheel_rad, -0.1);
  EXPECT_TRUE(read.sensors.holding);
  ASSERT_EQ(read.heard.size(), 2U);
  EXPECT_EQ(read.heard[0].channel, 7U);
  EXPECT_THAT(read.heard[0].bytes, ElementsAre(1, 2, 255));
  EXPECT_EQ(read.heard[0].signal_strength_dbm, -60.5);
  EXPECT_TRUE(std::isnan(read.heard[1].signal_strength_dbm));
  EXPECT_THAT(differences(3, answered, some_outputs()), ElementsAre());
}

TEST(RobotTrace, BeginsAnewWithANewController) {
  const Folder folder;
  runtime::StepTrace{folder.path(), 3}.ask(some_inputs());
  runtime::StepTrace{folder.path(), 3}.answer(some_outputs());
  TraceReader reader{runtime::robot_trace_in(folder.path(), 3), runtime::kRobotTrace};
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(reader.next(bytes));
  EXPECT_NO_THROW((void)read_outputs(bytes));
  EXPECT_FALSE(reader.next(bytes));
}

TEST(RobotTrace, OfOneStepSurvivesBeforeItsControllerIsCalled) {
  const Folder folder;
  runtime::StepTrace trace{folder.path(), 3};
  trace.ask(some_inputs());
  TraceReader reader{runtime::robot_trace_in(folder.path(), 3), runtime::kRobotTrace};
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(reader.next(bytes));
}

TEST(AnswersOfAController, DifferInEachOfTheirParts) {
  const auto first_difference = [](const auto& change) {
    caravan::Outputs changed = some_outputs();
    change(changed);
    const auto found = differences(3, some_outputs(), changed);
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? "" : found[0].quantity + ": " + found[0].one + " | " + found[0].other;
  };
  using Outputs = caravan::Outputs;
  EXPECT_EQ(first_difference([](Outputs& o) { o.left_mps = 0.125; }), "answer.left_mps: 0.25 | 0.125");
  EXPECT_EQ(first_difference([](Outputs& o) { o.right_mps = 0.5; }), "answer.right_mps: -0.5 | 0.5");
  EXPECT_EQ(first_difference([](Outputs& o) { o.gripper_closed = false; }),
            "answer.gripper_closed: yes | no");
  EXPECT_EQ(first_difference([](Outputs& o) { o.tuned_channel = 0; }), "answer.tuned_channel: 9 | 0");
  EXPECT_EQ(first_difference([](Outputs& o) { o.frames.pop_back(); }), "answer.frames: 2 | 1");
  EXPECT_EQ(first_difference([](Outputs& o) { o.frames[1].channel = 8; }), "answer.frame_2.channel: 9 | 8");
  EXPECT_EQ(first_difference([](Outputs& o) {
              o.frames[0].bytes = {1, 3};
            }),
            "answer.frame_1.bytes: 0102 | 0103");
}

TEST(AnswersOfAController, AreEqualWhenOnlyTheSignOfAZeroOrTheReportDiffers) {
  caravan::Outputs one;
  caravan::Outputs other;
  other.left_mps = -0.0;
  other.report.emplace();
  EXPECT_THAT(differences(1, one, other), ElementsAre());
}

}  // namespace
}  // namespace caravan::experiment
