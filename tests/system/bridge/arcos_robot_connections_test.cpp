// SPDX-License-Identifier: Apache-2.0
// The connections of an emulated Pioneer: which hosts and GPS clients it accepts and disconnects, and the
// world that must serve its body.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "tests/system/bridge/support/arcos_host.hpp"
#include "tests/system/bridge/support/arcos_robot.hpp"
#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {
namespace {

using bridge::arcos::Bytes;
using bridge::arcos::encode;
using bridge::arcos::Order;
using bridge::arcos::Sip;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

TEST_F(ArcosRobot, AHostThatHangsUpStopsTheWheels) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
  host.hang_up();
  EXPECT_TRUE(robot_.process->prints("the host has gone", kPatience));
  EXPECT_TRUE(truth_.rests(1));
  Host second{robot_.port};
  second.open();
  EXPECT_TRUE(second.sip([](const Sip&) { return true; })) << "the next one is welcome";
}

TEST_F(ArcosRobot, AHostThatConnectsAgainAtOnceIsLetInEachTime) {
  std::optional<Host> host{robot_.port};
  for (int times = 0; times < 10; ++times) {
    host->say(encode(Order::kPulse));
    ASSERT_TRUE(host->next()) << "time " << times << "\n" << robot_.process->output();
    host.reset();
    host.emplace(robot_.port);
  }
}

TEST_F(ArcosRobot, AHostThatReadsNothingIsLetGoAndTheWheelsStop) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
  EXPECT_TRUE(eventually(
      [&] {
        for (int i = 0; i < 500; ++i) host.say(encode(Order::kConfig));
        return !host.is_connected();
      },
      kPatience));
  EXPECT_TRUE(robot_.process->prints("the host has gone", kPatience)) << robot_.process->output();
  EXPECT_TRUE(truth_.rests(1));
}

TEST_F(ArcosRobot, TakesOneHostAtATime) {
  Host first{robot_.port};
  first.open();
  ASSERT_TRUE(first.sip([](const Sip&) { return true; }));
  Host second{robot_.port};
  second.say(encode(Order::kPulse));
  EXPECT_EQ(second.next(), std::nullopt);
  EXPECT_TRUE(robot_.process->prints("a host was turned away: 127.0.0.1:", kPatience));
  EXPECT_TRUE(first.sip([](const Sip&) { return true; }));
}

TEST_F(ArcosRobot, WhoeverSendsNoPacketLosesTheLineToAHost) {
  Host silent{robot_.port};
  EXPECT_TRUE(robot_.process->prints("has sent no ARCOS packet for 5 s", kPatience));
  Host host{robot_.port};
  host.open();
  EXPECT_TRUE(host.sip([](const Sip&) { return true; })) << robot_.process->output();
}

TEST_F(ArcosRobot, ItsGpsReceiverServesOneClientAndSaysWhoWasTurnedAway) {
  const auto first = Socket::to(robot_.gps_port);
  const auto speaks = [](const Socket& client) { return !client.read(50ms).value_or(Bytes{}).empty(); };
  ASSERT_TRUE(eventually([&] { return speaks(*first); }, kPatience));
  const auto second = Socket::to(robot_.gps_port);
  EXPECT_TRUE(robot_.process->prints("a client of the GPS receiver was turned away: 127.0.0.1:", kPatience));
  EXPECT_TRUE(eventually([&] { return !second->read(50ms); }, kPatience)) << "the connection ends";
  EXPECT_TRUE(eventually([&] { return speaks(*first); }, kPatience));
}

TEST_F(ArcosRobot, OfTwoWithOneNumberTheSecondEndsAndNamesTheFirst) {
  const Robot second = start_robot(1);
  EXPECT_EQ(second.process->wait(kPatience), 2) << second.process->output();
  EXPECT_THAT(second.process->output(), HasSubstr("robot 1 is already served by arcos_robot 1, pid " +
                                                  std::to_string(robot_.process->pid())));
  Host host{robot_.port};
  host.open();
  EXPECT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
}

TEST_F(Field, ARobotWithoutABodySaysWhatIsMissing) {
  const auto world = start_world(room(1, 0), "");
  const Robot robot = start_robot(1);
  EXPECT_TRUE(robot.process->prints("nobody serves rt/body_1/sensors in DDS domain " +
                                        std::to_string(lock_.domain()) +
                                        ", hosts are turned away: start world_server there with --bodies 1",
                                    kPatience))
      << robot.process->output();
  Host host{robot.port};
  EXPECT_TRUE(robot.process->prints("a host was turned away: the robot has no body yet", kPatience));
}

TEST_F(ArcosRobot, AnotherSessionOfTheWorldIsARobotSwitchedOffAndOn) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip&) { return true; }));
  kill_at_once(*world_);
  world_ = start_world(room(1, 0), "1");
  EXPECT_TRUE(eventually(
      [&] {
        host.listen(50ms);
        host.say(encode(Order::kPulse));
        return !host.is_connected();
      },
      kPatience))
      << "the connection ends";
  EXPECT_TRUE(eventually(
      [&] {
        Host again{robot_.port};
        again.say(encode(Order::kPulse));
        return again.next() == Bytes{0};
      },
      kPatience));
}

TEST_F(Field, BodiesNeedFreePacing) {
  auto world = start_world(replaced(room(1, 0), "\"free\"", "\"fast\""), "1");
  EXPECT_EQ(world->wait(kPatience), 2);
  EXPECT_THAT(world->output(), HasSubstr("--bodies: experiment.pacing must be \"free\""));
  auto other = start_world(room(1, 0), "2");
  EXPECT_EQ(other->wait(kPatience), 2);
  EXPECT_THAT(other->output(), HasSubstr("--bodies"));
}

}  // namespace
}  // namespace caravan::test
