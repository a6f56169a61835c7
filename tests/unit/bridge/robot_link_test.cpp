// SPDX-License-Identifier: Apache-2.0
// The host's end of the line, against bytes written out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/robot_link.hpp"

namespace caravan::bridge {
namespace {

using arcos::Bytes;
using arcos::encode;
using arcos::Order;
using arcos::to_packet;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The numbers of the commands among the bytes.
std::vector<int> numbers_in(const Bytes& bytes) {
  arcos::PacketFinder finder;
  std::vector<int> numbers;
  for (const Bytes& data : finder.feed(bytes)) numbers.push_back(data[0]);
  return numbers;
}

const Bytes kEcho0 = encode(Order::kPulse);
const Bytes kEcho1 = encode(Order::kOpen);
Bytes names() { return to_packet(encode(arcos::Names{"Fred", "Pioneer", "p3dx"})); }
Bytes sip() { return to_packet(encode(arcos::Sip{})); }

RobotLink running_link(Time now) {
  RobotLink link{{}};
  link.up(now);
  (void)link.receive(kEcho0, now);
  (void)link.receive(kEcho1, now);
  (void)link.receive(names(), now);
  (void)link.receive(sip(), now);
  (void)link.take_output();
  (void)link.take_notices();
  return link;
}

TEST(RobotLink, OpensByThreeSyncsEachAnswered) {
  RobotLink link{{}};
  link.up(0s);
  EXPECT_EQ(link.take_output(), encode(Order::kPulse));
  (void)link.receive(kEcho0, 10ms);
  EXPECT_EQ(link.take_output(), encode(Order::kOpen));
  (void)link.receive(kEcho1, 20ms);
  EXPECT_EQ(link.take_output(), encode(Order::kClose)) << "SYNC2 is the same packet";
  (void)link.receive(names(), 30ms);
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(1, 29, 5, 5, 6, 4, 28, 18))
      << "OPEN, then motors and sonar on, and the question how it is set up";
  EXPECT_EQ(link.names()->subtype, "p3dx");
  EXPECT_FALSE(link.is_running());
  EXPECT_THAT(link.receive(sip(), 40ms), SizeIs(1));
  EXPECT_TRUE(link.is_running());
}

TEST(RobotLink, TakesNoSyncOutOfTurn) {
  RobotLink link{{}};
  link.up(0s);
  (void)link.take_output();
  (void)link.receive(kEcho1, 10ms);
  (void)link.receive(names(), 10ms);
  EXPECT_THAT(link.take_output(), IsEmpty());
}

TEST(RobotLink, ClosesAConnectionThatSomebodyLeftOpenAndBeginsAgain) {
  RobotLink link{{}};
  link.up(0s);
  (void)link.receive(kEcho0, 10ms);
  (void)link.take_output();
  EXPECT_THAT(link.receive(sip(), 20ms), IsEmpty());
  EXPECT_EQ(link.take_output(), encode(Order::kClose));
  link.tick(410ms);
  EXPECT_EQ(link.take_output(), encode(Order::kPulse));
}

TEST(RobotLink, WithoutAnswerTriesThreeTimesThenWantsTheLineAnew) {
  RobotLink link{{}};
  link.up(0s);
  int syncs = 0;
  Time now{0};
  while (!link.take_reopen()) {
    syncs += static_cast<int>(numbers_in(link.take_output()).size());
    ASSERT_TRUE(link.next_deadline());
    now = *link.next_deadline();
    link.tick(now);
    ASSERT_LT(now, 10s);
  }
  EXPECT_EQ(syncs, 3);
  EXPECT_EQ(now, 1200ms);
  EXPECT_FALSE(link.take_reopen()) << "once";
  EXPECT_THAT(link.take_notices().back().text, HasSubstr("no robot answers"));
}

TEST(RobotLink, TellsOfAWatchdogThatIsTooSlowToStopARobotWithACutCable) {
  const auto told = [](std::uint16_t watchdog_ms) {
    RobotLink link = running_link(0s);
    arcos::Settings settings;
    settings.watchdog_ms = watchdog_ms;
    (void)link.receive(to_packet(encode(settings)), 10ms);
    const auto notices = link.take_notices();
    return notices.empty() ? std::string{} : notices.front().text;
  };
  EXPECT_THAT(told(2000), HasSubstr("after 2000 ms only"));
  EXPECT_THAT(told(0), HasSubstr("is off"));
  EXPECT_THAT(told(600), IsEmpty());
}

TEST(RobotLink, SendsAPulseAtLeastOnceASecond) {
  RobotLink link = running_link(0s);
  int pulses = 0;
  for (Time now{0}; now <= 10s; now += 100ms) {
    (void)link.receive(sip(), now);
    link.tick(now);
    for (const int number : numbers_in(link.take_output())) pulses += number == 0 ? 1 : 0;
  }
  EXPECT_GE(pulses, 10);
}

TEST(RobotLink, ASilentRobotIsNotHeardAfter400MillisecondsAndGivenUpAfter2Seconds) {
  RobotLink link = running_link(1s);
  EXPECT_TRUE(link.is_heard(1399ms));
  EXPECT_FALSE(link.is_heard(1400ms));
  (void)link.receive(sip(), 2s);
  EXPECT_TRUE(link.is_heard(2s)) << "and heard again";
  link.tick(3999ms);
  EXPECT_FALSE(link.take_reopen());
  link.tick(4s);
  EXPECT_TRUE(link.take_reopen());
  EXPECT_THAT(link.take_notices().back().text, HasSubstr("silent"));
}

TEST(RobotLink, StopsByStopAndByZeroSpeeds) {
  RobotLink link = running_link(0s);
  link.stop();
  Bytes expected = encode(Order::kStop);
  const Bytes zero = encode(Order::kWheelSpeeds, 0);
  expected.insert(expected.end(), zero.begin(), zero.end());
  EXPECT_EQ(link.take_output(), expected);
}

TEST(RobotLink, SaysNothingOnALineThatIsDown) {
  RobotLink link = running_link(0s);
  link.down();
  link.stop();
  link.send(encode(Order::kSpeed, 100));
  link.tick(1s);
  EXPECT_THAT(link.take_output(), IsEmpty());
  EXPECT_FALSE(link.next_deadline());
}

TEST(RobotLink, TellsOfGarbageButNotForEachByte) {
  RobotLink link = running_link(0s);
  std::size_t told = 0;
  for (int i = 0; i < 100; ++i) {
    (void)link.receive(Bytes(100, 0x55), 1ms * i);
    told += link.take_notices().size();
  }
  EXPECT_GE(told, 1U);
  EXPECT_LE(told, 10U);
}

}  // namespace
}  // namespace caravan::bridge
