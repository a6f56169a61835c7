// SPDX-License-Identifier: Apache-2.0
// The real agent; the test takes the place of its world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/core/agent.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class AgentProcess : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> agent(const std::string& robot) const {
    return {"robot_agent",
            "--scenario",
            scenario("small.toml"),
            "--domain",
            std::to_string(lock_.domain()),
            "--lease",
            std::to_string(short_lease_s()),
            "--robot",
            robot};
  }
  [[nodiscard]] runtime::BusConfig bus_config() const { return {.role = "test", .domain = lock_.domain()}; }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(AgentProcess, HasItsFiveTopicsAndNoOthers) {
  std::mutex mutex;
  std::set<std::string> written;
  std::set<std::string> read;
  runtime::Bus bus{bus_config(), [&](const runtime::Discovery& news) {
                     const std::lock_guard lock{mutex};
                     if (news.kind == runtime::Discovery::Kind::kWriterFound) written.insert(news.topic);
                     if (news.kind == runtime::Discovery::Kind::kReaderFound) read.insert(news.topic);
                   }};
  const Process process{agent("3"), folder_ / "agent.log"};
  (void)eventually(
      [&] {
        const std::lock_guard lock{mutex};
        return written.size() >= 3 && read.size() >= 2;
      },
      kPatience);
  // The agent creates all endpoints before it reports that it waits, so no further one can appear.
  ASSERT_TRUE(process.prints("waiting for the world", kPatience));
  bus.close();
  EXPECT_THAT(written,
              UnorderedElementsAre("rt/robot_3/command", "rt/robot_3/radio/tx", "rt/robot_3/telemetry"));
  EXPECT_THAT(read, UnorderedElementsAre("rt/robot_3/sensors", "rt/robot_3/radio/rx"));
}

TEST_F(AgentProcess, SaysThatItWaitsForTheWorldAndUsesNoProcessorMeanwhile) {
  Process process{agent("1"), folder_ / "agent.log"};
  ASSERT_TRUE(process.prints("waiting for the world: nothing on rt/robot_1/sensors yet", kPatience));
  const auto before = process.cpu_time();
  const auto began = std::chrono::steady_clock::now();
  EXPECT_TRUE(process.runs_on_for(2s));
  const auto waited = std::chrono::steady_clock::now() - began;
  EXPECT_LE(process.cpu_time() - before, waited / 50) << "2 % of the time";
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
}

TEST_F(AgentProcess, OfTwoWithOneNumberTheSecondEndsAndNamesTheFirst) {
  Process first{agent("1"), folder_ / "first.log"};
  ASSERT_TRUE(first.prints("waiting for the world", kPatience));
  Process second{agent("1"), folder_ / "second.log"};
  EXPECT_EQ(second.wait(kPatience), 2) << second.output();
  EXPECT_THAT(second.output(), HasSubstr("robot 1 is already run by pid " + std::to_string(first.pid())));
  EXPECT_EQ(first.wait(0ms), std::nullopt) << first.output();
}

TEST_F(AgentProcess, TakesOverFromOneThatWasKilled) {
  {
    Process first{agent("1"), folder_ / "first.log"};
    ASSERT_TRUE(first.prints("waiting for the world", kPatience));
  }
  // The world sends no other frame until this one is answered. The frame arrives while the first agent still
  // counts as alive.
  const Collector<msg::RobotCommandPubSubType> commands{bus_config(), idl::kCommand, 1};
  runtime::Bus bus{bus_config()};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  msg::SensorFrame frame;
  frame.session(7);
  sensors.write(frame);
  Process second{agent("1"), folder_ / "second.log"};
  EXPECT_TRUE(commands.first([](const msg::RobotCommand&) { return true; })) << second.output();
  EXPECT_TRUE(second.runs_on_for(longer_than_a_short_lease())) << second.output();
}

TEST_F(AgentProcess, ShowsItsFramesInThePapersFormWhenAskedTo) {
  std::vector<std::string> line = agent("3");
  line.insert(line.end(), {"--log-level", "trace"});
  const Process process{line, folder_ / "agent.log"};
  runtime::Bus bus{bus_config()};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 3);
  msg::SensorFrame frame;
  frame.session(7);
  sensors.write(frame);
  EXPECT_TRUE(process.prints("sends t_s=0.000 channel=0 WAIT_3_EXPLORE", kPatience)) << process.output();
}

TEST_F(AgentProcess, RefusesANumberOutOfRange) {
  for (const std::string robot : {"0", "5"}) {
    Process process{agent(robot), folder_ / "agent.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    EXPECT_THAT(process.output(), HasSubstr("small.toml"));
    EXPECT_THAT(process.output(), HasSubstr("robot"));
  }
}

/// A made-up drive: position and ranges change with each frame, and so do the commands.
msg::SensorFrame recorded_frame(int step) {
  msg::SensorFrame frame;
  frame.stamp(idl::to_wire(step * 32ms));
  frame.session(7);
  const double s = step;
  for (std::size_t i = 0; i < 16; ++i) {
    frame.sonar_range_m()[i] = 0.4 + std::fmod(0.37 * s + 0.9 * static_cast<double>(i), 4.5);
  }
  frame.gps_x_m(-4.5 + 0.03 * s);
  frame.gps_y_m(-4.5 + 0.02 * s);
  frame.compass_yaw_rad(std::sin(0.01 * s));
  frame.left_wheel_rad(0.3 * s);
  frame.right_wheel_rad(0.3 * s);
  return frame;
}

agent::Inputs to_inputs(const msg::SensorFrame& frame) {
  agent::Inputs inputs;
  inputs.now = idl::to_time(frame.stamp());
  inputs.sensors = {.sonar_range_m = frame.sonar_range_m(),
                    .sonar_age_s = frame.sonar_age_s(),
                    .p_WB = {frame.gps_x_m(), frame.gps_y_m()},
                    .yaw_WB_rad = frame.compass_yaw_rad(),
                    .left_wheel_rad = frame.left_wheel_rad(),
                    .right_wheel_rad = frame.right_wheel_rad(),
                    .holding = frame.holding()};
  return inputs;
}

TEST_F(AgentProcess, AnswersRecordedSensorsWithoutAWorldBitForBit) {
  const Process process{agent("1"), folder_ / "agent.log"};
  runtime::Bus bus{bus_config()};
  const Collector<msg::RobotCommandPubSubType> commands{bus_config(), idl::kCommand, 1};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  agent::Agent twin{agent::load_config(runtime::TomlDocument::load(scenario("small.toml")), 1)};
  bool moved = false;
  for (int step = 0; step < 200; ++step) {
    msg::SensorFrame frame = recorded_frame(step);
    sensors.write(frame);
    const auto answer =
        commands.first([&](const msg::RobotCommand& one) { return one.stamp() == frame.stamp(); });
    ASSERT_TRUE(answer) << "no answer in step " << step << "; its log:\n" << process.output();
    const agent::Outputs expected = twin.step(to_inputs(frame));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(answer->left_mps()),
              std::bit_cast<std::uint64_t>(expected.wheels.left_mps))
        << "step " << step;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(answer->right_mps()),
              std::bit_cast<std::uint64_t>(expected.wheels.right_mps))
        << "step " << step;
    moved = moved || answer->left_mps() != 0.0;
  }
  EXPECT_TRUE(moved);
}

TEST_F(AgentProcess, StepsWithoutARadioThatIsDueButSilentAndSaysSo) {
  const Process process{agent("1"), folder_ / "agent.log"};
  runtime::Bus bus{bus_config()};
  const Collector<msg::RobotCommandPubSubType> commands{bus_config(), idl::kCommand, 1};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  msg::SensorFrame frame = recorded_frame(0);
  frame.radio_due(true);
  sensors.write(frame);
  EXPECT_TRUE(commands.first([](const msg::RobotCommand&) { return true; }));
  EXPECT_THAT(process.output(), HasSubstr("radio due but silent"));
}

TEST_F(AgentProcess, WaitsForTheRadioThatIsDue) {
  const Process process{agent("1"), folder_ / "agent.log"};
  runtime::Bus bus{bus_config()};
  const Collector<msg::RobotCommandPubSubType> commands{bus_config(), idl::kCommand, 1};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  auto receives = bus.writer<msg::RadioReceivePubSubType>(idl::kRadioReceive, 1);
  msg::SensorFrame frame = recorded_frame(0);
  frame.radio_due(true);
  msg::RadioReceive receive;
  receive.stamp(frame.stamp());
  receive.session(frame.session());
  sensors.write(frame);
  receives.write(receive);
  EXPECT_TRUE(commands.first([](const msg::RobotCommand&) { return true; }));
  EXPECT_THAT(process.output(), Not(HasSubstr("radio due but silent")));
}

}  // namespace
}  // namespace caravan::test
