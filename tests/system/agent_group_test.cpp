// SPDX-License-Identifier: Apache-2.0
// Several agents in one process; the test takes the place of their world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class AgentGroup : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> agents(const std::vector<std::string>& which) const {
    std::vector<std::string> line{"robot_agent",
                                  "--scenario",
                                  scenario("small.toml"),
                                  "--domain",
                                  std::to_string(lock_.domain()),
                                  "--lease",
                                  std::to_string(short_lease_s())};
    line.insert(line.end(), which.begin(), which.end());
    return line;
  }
  [[nodiscard]] runtime::BusConfig bus_config() const { return {.role = "test", .domain = lock_.domain()}; }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

msg::SensorFrame frame_of(int step, double x_m) {
  msg::SensorFrame frame;
  frame.stamp(idl::to_wire(step * 32ms));
  frame.session(7);
  frame.sonar_range_m().fill(5.0);
  frame.gps_x_m(x_m);
  return frame;
}

TEST_F(AgentGroup, HasTheTopicsOfItsRobotsOnOneParticipant) {
  std::mutex mutex;
  std::set<std::string> written;
  std::set<runtime::ParticipantId> participants;
  runtime::Bus bus{bus_config(), [&](const runtime::Discovery& news) {
                     const std::lock_guard lock{mutex};
                     if (news.kind != runtime::Discovery::Kind::kWriterFound) return;
                     written.insert(news.topic);
                     participants.insert(news.participant);
                   }};
  const Process process{agents({"--robots", "1,3-4"}), folder_ / "agents.log"};
  EXPECT_TRUE(eventually(
      [&] {
        const std::lock_guard lock{mutex};
        return written.size() >= 9;
      },
      kPatience));
  ASSERT_TRUE(process.prints("waiting for the world", kPatience));
  bus.close();
  std::set<std::string> expected;
  for (const std::string robot : {"1", "3", "4"}) {
    for (const std::string topic : {"command", "radio/tx", "telemetry"}) {
      expected.insert(std::string{"rt/robot_"}.append(robot).append("/").append(topic));
    }
  }
  EXPECT_EQ(written, expected);
  EXPECT_EQ(participants.size(), 1U);
}

TEST_F(AgentGroup, EachRobotStepsOnItsOwnFramesAlone) {
  const Process process{agents({"--robots", "1-2"}), folder_ / "agents.log"};
  runtime::Bus bus{bus_config()};
  const Collector<msg::RobotCommandPubSubType> firsts{bus_config(), idl::kCommand, 1};
  const Collector<msg::RobotCommandPubSubType> seconds{bus_config(), idl::kCommand, 2};
  auto first = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  auto second = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 2);
  for (int step = 0; step < 5; ++step) {
    msg::SensorFrame frame = frame_of(step, 0.01 * step);
    first.write(frame);
    ASSERT_TRUE(firsts.first([&](const msg::RobotCommand& one) { return one.stamp() == frame.stamp(); }))
        << process.output();
  }
  EXPECT_TRUE(seconds.samples().empty()) << "robot 2 was told nothing yet";
  msg::SensorFrame frame = frame_of(0, 3.0);
  second.write(frame);
  EXPECT_TRUE(seconds.first([&](const msg::RobotCommand& one) { return one.stamp() == frame.stamp(); }))
      << process.output();
}

TEST_F(AgentGroup, ARobotThatWaitsForItsRadioHoldsUpNoOther) {
  const Process process{agents({"--robots", "1-2"}), folder_ / "agents.log"};
  runtime::Bus bus{bus_config()};
  const Collector<msg::RobotCommandPubSubType> firsts{bus_config(), idl::kCommand, 1};
  const Collector<msg::RobotCommandPubSubType> seconds{bus_config(), idl::kCommand, 2};
  auto first = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  auto second = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 2);
  msg::SensorFrame frame = frame_of(0, 0.0);
  frame.radio_due(true);
  first.write(frame);
  ASSERT_TRUE(process.prints("session=7 robot=1:", kPatience)) << process.output();
  frame.radio_due(false);
  second.write(frame);
  EXPECT_TRUE(seconds.first([](const msg::RobotCommand&) { return true; })) << process.output();
  EXPECT_TRUE(firsts.first([](const msg::RobotCommand&) { return true; })) << process.output();
  EXPECT_THAT(process.output(), HasSubstr("radio due but silent for 1 s: stepping without it, robot=1"));
}

TEST_F(AgentGroup, GivesWayToAnotherProcessThatRunsOneOfItsRobots) {
  Process first{agents({"--robot", "3"}), folder_ / "first.log"};
  ASSERT_TRUE(first.prints("waiting for the world", kPatience));
  Process group{agents({"--robots", "1-4"}), folder_ / "group.log"};
  EXPECT_EQ(group.wait(kPatience), 2) << group.output();
  EXPECT_THAT(group.output(), HasSubstr("robot 3 is already run by pid " + std::to_string(first.pid())));
  EXPECT_EQ(first.wait(0ms), std::nullopt) << first.output();
}

TEST_F(AgentGroup, TakesOverFromOneThatWasKilled) {
  {
    Process first{agents({"--robots", "1-2"}), folder_ / "first.log"};
    ASSERT_TRUE(first.prints("waiting for the world", kPatience));
  }
  const Collector<msg::RobotCommandPubSubType> ones{bus_config(), idl::kCommand, 1};
  const Collector<msg::RobotCommandPubSubType> threes{bus_config(), idl::kCommand, 3};
  runtime::Bus bus{bus_config()};
  auto first = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  auto third = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 3);
  msg::SensorFrame frame = frame_of(0, 0.0);
  first.write(frame);
  third.write(frame);
  Process second{agents({"--robots", "1-4"}), folder_ / "second.log"};
  EXPECT_TRUE(ones.first([](const msg::RobotCommand&) { return true; })) << second.output();
  EXPECT_TRUE(threes.first([](const msg::RobotCommand&) { return true; })) << second.output();
  EXPECT_TRUE(second.runs_on_for(longer_than_a_short_lease())) << second.output();
}

TEST_F(AgentGroup, RefusesABadChoiceOfRobots) {
  const std::vector<std::vector<std::string>> bad{{},
                                                  {"--robot", "1", "--robots", "2-3"},
                                                  {"--robots", "2-3", "--robots", "4"},
                                                  {"--robots", "3-2"},
                                                  {"--robots", "1-5"}};
  for (const auto& which : bad) {
    SCOPED_TRACE(::testing::PrintToString(which));
    Process process{agents(which), folder_ / "agents.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    EXPECT_THAT(process.output(), HasSubstr("robot"));
  }
}

}  // namespace
}  // namespace caravan::test
