// SPDX-License-Identifier: Apache-2.0
// P-50, P-52 to P-54, P-65, P-66: what answers a sensor frame.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/contract/agent/played_run.hpp"

namespace caravan::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSubsetOf;

std::set<std::int64_t> steps_to(int last) {
  std::set<std::int64_t> steps;
  for (int step = 0; step <= last; ++step) steps.insert(step);
  return steps;
}

TEST_F(AgentContract, P50EveryAnswerCarriesStampAndSessionOfItsFrame) {
  const auto agent = start_agent();
  drive(7, 0, 30);
  EXPECT_THAT(listener_.steps(), IsSubsetOf(steps_to(30))) << "an answer has the stamp of no frame";
  EXPECT_THAT(listener_.sessions(), ElementsAre(7U)) << "an answer has a session of no frame";
}

TEST_F(AgentContract, P52StepsOnceOnEachFrameThatIsNewerThanTheLast) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 5));
  world_->send(frame_of(7, 3));
  world_->send(frame_of(7, 5));
  drive(7, 6, 6);
  for (const int step : {3, 5, 6})
    EXPECT_EQ(listener_.answer(7, step).commands.size(), 1U) << "answers to step " << step;
  drive(7, 20, 20);
  EXPECT_TRUE(listener_.answer(7, 13).commands.empty()) << "it answers a frame that has not come";
}

TEST_F(AgentContract, P52AnswersWithTelemetryCommandRadioAndSaysWhetherThereIsTelemetry) {
  const auto agent = start_agent();
  constexpr int kLast = 40;
  for (int step = 0; step <= kLast; ++step) {
    ASSERT_NO_FATAL_FAILURE(drive(7, step, step));
    ASSERT_TRUE(transmits(7, step)) << "no RadioTransmit in step " << step << ". " << log();
  }
  int in_order = 0;
  for (int step = 0; step <= kLast; ++step) {
    const auto has_telemetry = [&] { return !listener_.answer(7, step).telemetry.empty(); };
    if (!listener_.answer(7, step).commands.front().reported()) {
      EXPECT_FALSE(has_telemetry()) << "step " << step << ": Telemetry, but the command does not say so";
    } else {
      EXPECT_TRUE(eventually(has_telemetry, subject().patience))
          << "step " << step << ": the command says that there is Telemetry";
    }
    const std::string order = listener_.answer(7, step).order;
    in_order += order == "CR" || order == "TCR" ? 1 : 0;
  }
  // A lost sample comes later than one of another topic, without fault of the agent.
  EXPECT_GT(in_order, kLast / 2) << "the last one came in the order " << listener_.answer(7, kLast).order;
}

TEST_F(AgentContract, P53AnswersTheFirstFrameAlthoughItWasSentBeforeTheAgentCame) {
  world_->send(frame_of(7, 0));
  const auto agent = start_agent();
  EXPECT_TRUE(commands(7, 0)) << "is its reader TRANSIENT_LOCAL? " << log();
}

TEST_F(AgentContract, P54SendsOneTransmissionForEveryFrameEvenIfItIsSilent) {
  const auto agent = start_agent();
  for (int step = 0; step <= 20; ++step) {
    ASSERT_NO_FATAL_FAILURE(drive(7, step, step));
    ASSERT_TRUE(transmits(7, step)) << "the radio would wait for ever: no RadioTransmit in step " << step
                                    << ". " << log();
  }
  for (int step = 0; step <= 20; ++step) EXPECT_EQ(listener_.answer(7, step).transmits.size(), 1U) << step;
}

TEST_F(AgentContract, P65CommandsAreFiniteWhateverTheSensorsKnow) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  for (int step = 4; step < 16; ++step) {
    msg::SensorFrame frame = frame_of(7, step);
    // Sonars without echo, without knowledge, and touching; the place and the wheels known and not.
    const std::array<double, 3> ranges{std::numeric_limits<double>::infinity(), kUnknown, 0.0};
    for (double& range_m : frame.sonar_range_m()) range_m = ranges[static_cast<std::size_t>(step) % 3];
    if (step % 2 == 0) {
      frame.gps_x_m(kUnknown);
      frame.gps_y_m(kUnknown);
    }
    if (step % 4 < 2) frame.compass_yaw_rad(kUnknown);
    if (step >= 10) {
      frame.left_wheel_rad(kUnknown);
      frame.right_wheel_rad(kUnknown);
    }
    world_->send(frame);
    ASSERT_TRUE(commands(7, step)) << log();
    const msg::RobotCommand command = listener_.answer(7, step).commands.front();
    EXPECT_TRUE(std::isfinite(command.left_mps()) && std::isfinite(command.right_mps()))
        << "step " << step << ": " << command.left_mps() << " and " << command.right_mps() << " m/s";
  }
}

TEST_F(AgentContract, P66AnswersTheNewestFrameHoweverManyCameMeanwhile) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  for (int step = 4; step <= 40; ++step) world_->send(frame_of(7, step));
  EXPECT_TRUE(commands(7, 40)) << log();
}

}  // namespace
}  // namespace caravan::test
