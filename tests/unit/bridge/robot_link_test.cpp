// SPDX-License-Identifier: Apache-2.0
// The host's end of the line. The bytes of the robot are written out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>

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
using ::testing::Not;
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

Bytes settings(const arcos::Names& names = {"Fred", "Pioneer", "p3dx"}, std::uint16_t watchdog_ms = 300) {
  arcos::Settings settings;
  settings.name = names.name;
  settings.type = names.type;
  settings.subtype = names.subtype;
  settings.sip_period_ms = 100;
  settings.watchdog_ms = watchdog_ms;
  return to_packet(encode(settings));
}
std::string told_by(RobotLink& link) {
  std::string text;
  for (const Notice& notice : link.take_notices()) text += notice.text + "\n";
  return text;
}
/// A link that is open, has received its first SIP and has sent CONFIG.
RobotLink checking_link(Time now, const Bytes& answer = names()) {
  RobotLink link{{}};
  link.up(now);
  (void)link.receive(kEcho0, now);
  (void)link.receive(kEcho1, now);
  (void)link.receive(answer, now);
  (void)link.receive(sip(), now);
  (void)link.take_output();
  (void)link.take_notices();
  return link;
}
RobotLink running_link(Time now) {
  RobotLink link = checking_link(now);
  (void)link.receive(settings(), now);
  (void)link.take_notices();
  return link;
}

TEST(RobotLink, TellsARobotToStopBeforeTheFirstSync) {
  RobotLink link{{}};
  link.up(0s);
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(29, 0))
      << "SYNC0 is PULSE to a robot that is open, which may go on with what it was told last";
}

TEST(RobotLink, OpensByThreeSyncsEachAnswered) {
  RobotLink link{{}};
  link.up(0s);
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(29, 0));
  (void)link.receive(kEcho0, 10ms);
  EXPECT_EQ(link.take_output(), encode(Order::kOpen));
  (void)link.receive(kEcho1, 20ms);
  EXPECT_EQ(link.take_output(), encode(Order::kClose)) << "SYNC2 is the same packet";
  (void)link.receive(names(), 30ms);
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(1, 29, 5, 5, 6, 23, 23, 10, 4, 28, 18))
      << "OPEN, then limits, motors and sonar on, and the question how it is set up";
  EXPECT_EQ(link.names()->subtype, "p3dx");
  EXPECT_THAT(link.receive(sip(), 40ms), IsEmpty());
  EXPECT_FALSE(link.is_running()) << "it may be another robot than SYNC2 said";
  (void)link.receive(settings(), 50ms);
  EXPECT_TRUE(link.is_running());
  EXPECT_THAT(link.receive(sip(), 140ms), SizeIs(1));
}

TEST(RobotLink, SetsTheLimitsOfTurningAsThoseOfDriving) {
  RobotLink link{{.acceleration_mps2 = 1.0, .speed_limit_mps = 0.5, .track_m = 0.4}};
  link.up(0s);
  for (const Bytes& answer : {kEcho0, kEcho1}) (void)link.receive(answer, 0s);
  (void)link.take_output();
  (void)link.receive(names(), 0s);
  std::map<std::pair<int, bool>, int> set;
  arcos::PacketFinder finder;
  for (const Bytes& data : finder.feed(link.take_output())) {
    const auto command = arcos::decode_command(data);
    const int* number = std::get_if<int>(&command->argument);
    if (number != nullptr) set[{command->number, *number < 0}] = *number;
  }
  EXPECT_EQ((set[{5, false}]), 1000);
  EXPECT_EQ((set[{5, true}]), -1000);
  EXPECT_EQ((set[{6, false}]), 500);
  EXPECT_EQ((set[{23, false}]), 286) << "1 m/s2 at 0.2 m from the middle, in degrees";
  EXPECT_EQ((set[{23, true}]), -286);
  EXPECT_EQ((set[{10, false}]), 143);
}

TEST(RobotLink, LeavesTheMotorsOffWhenItIsTold) {
  RobotLink link{{}};
  link.keep_motors_off(true);
  link.up(0s);
  for (const Bytes& answer : {kEcho0, kEcho1, names()}) (void)link.receive(answer, 0s);
  EXPECT_THAT(numbers_in(link.take_output()), Not(testing::Contains(4)));
}

TEST(RobotLink, ARobotThatIsAnotherBySync2ThanByConfigIsAskedAgain) {
  const Bytes garbled = to_packet(encode(arcos::Names{"Fder", "Pioneer", "p3dx"}));  // has the same checksum
  ASSERT_EQ((Bytes{garbled.end() - 2, garbled.end()}), (Bytes{names().end()[-2], names().end()[-1]}));
  RobotLink link = checking_link(0s, garbled);
  (void)link.receive(settings(), 10ms);
  EXPECT_FALSE(link.is_running());
  EXPECT_THAT(told_by(link),
              HasSubstr("the robot is Fder, Pioneer p3dx by SYNC2, but Fred, Pioneer p3dx by"));
  EXPECT_EQ(link.take_output(), encode(Order::kClose));
  link.tick(410ms);
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(29, 0)) << "STOP and SYNC0 again";
  for (const Bytes& answer : {kEcho0, kEcho1, names(), sip(), settings()}) (void)link.receive(answer, 500ms);
  EXPECT_TRUE(link.is_running());
  EXPECT_EQ(link.names()->name, "Fred");
}

TEST(RobotLink, ARobotThatKeepsToTwoNamesIsTakenButNotOneOfTwoKinds) {
  for (const bool same_kind : {true, false}) {
    RobotLink link{{}};
    link.up(0s);
    Time now{0};
    for (int round = 0; round < 5 && !link.is_running(); ++round) {
      const Bytes config = settings({"Other", "Pioneer", same_kind ? "P3DX" : "p3at"});
      for (const Bytes& answer : {kEcho0, kEcho1, names(), sip(), config}) (void)link.receive(answer, now);
      now += 500ms;
      link.tick(now);
    }
    EXPECT_EQ(link.is_running(), same_kind);
  }
}

TEST(RobotLink, ARobotThatNeverAnswersConfigIsAskedSixTimesAndThenTakenUnchecked) {
  RobotLink link = checking_link(0s);
  int asked = 1;  // CONFIG was sent once with OPEN
  for (Time now{0}; !link.is_running(); now += 100ms) {
    ASSERT_LT(now, 10s);
    (void)link.receive(sip(), now);
    link.tick(now);
    for (const int number : numbers_in(link.take_output())) asked += number == 18 ? 1 : 0;
  }
  EXPECT_EQ(asked, 6);
  EXPECT_THAT(told_by(link), HasSubstr("does not answer CONFIG"));
}

TEST(RobotLink, ARobotThatNoLongerAnswersConfigDoesNotReceiveWhatItIsTold) {
  RobotLink link = running_link(0s);
  std::optional<Time> unsafe;
  for (Time now{0}; now < 10s; now += 100ms) {
    (void)link.receive(sip(), now);
    link.tick(now);
    const auto asked = numbers_in(link.take_output());
    const bool answers = now < 3s || now > 8s;
    if (answers && testing::Value(asked, testing::Contains(18))) (void)link.receive(settings(), now);
    if (!link.unsafe(now).empty() && !unsafe) unsafe = now;
  }
  ASSERT_TRUE(unsafe);
  EXPECT_GT(*unsafe, 3s);
  EXPECT_LE(*unsafe, 3s + 3600ms);
  EXPECT_THAT(link.unsafe(10s), IsEmpty()) << "it answers again";
}

/// The line carries fewer SIPs a second than the robot sends; answers to CONFIG wait in the same queue.
TEST(RobotLink, SipsThatArriveMoreSlowlyThanTheRobotSendsThemAreOldAndThatIsSeen) {
  RobotLink link = running_link(0s);
  std::optional<Time> unsafe;
  std::deque<Time> answers;  // times at which they leave the queue
  Time now{0};
  for (; now < 20s; now += 137ms) {  // the line carries 350 of 480 bytes a second
    (void)link.receive(sip(), now);
    link.tick(now);
    const auto asked = numbers_in(link.take_output());
    const Time late = now * 27 / 100;
    if (testing::Value(asked, testing::Contains(18))) answers.push_back(now + late);
    for (; !answers.empty() && answers.front() <= now; answers.pop_front())
      (void)link.receive(settings(), now);
    if (!link.unsafe(now).empty() && !unsafe) unsafe = now;
    ASSERT_TRUE(!unsafe || !link.unsafe(now).empty()) << now.count();
  }
  ASSERT_TRUE(unsafe);
  EXPECT_LE(*unsafe, 2500ms);
  for (int sips = 0; sips < 200; ++sips) (void)link.receive(sip(), now);
  EXPECT_THAT(link.unsafe(now), IsEmpty()) << "what had waited has come";
}

TEST(RobotLink, ARobotThatLeavesPacketsOutIsNotLateWhileItAnswersAtOnce) {
  RobotLink link = running_link(0s);
  Time late{0};
  for (Time now{0}; now < 60s; now += 140ms) {
    (void)link.receive(sip(), now);
    link.tick(now);
    const auto asked = numbers_in(link.take_output());
    if (testing::Value(asked, testing::Contains(18))) (void)link.receive(settings(), now);
    late = link.unsafe(now).empty() ? Time{0} : late + 140ms;
    ASSERT_LE(late, 300ms) << "not for long";
  }
}

TEST(RobotLink, SipsThatAreLostSeldomOrComeInBurstsAreNotLate) {
  RobotLink link = running_link(0s);
  for (int sips = 0; sips < 3000; ++sips) {
    if (sips % 30 == 29) continue;                                           // lost
    const Time now = 100ms * (sips % 10 < 3 ? sips - sips % 10 + 3 : sips);  // three arrive with the fourth
    (void)link.receive(sip(), now);
    ASSERT_TRUE(sips % 10 < 3 || link.unsafe(now).empty()) << sips;
    (void)link.receive(settings(), now);
  }
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
  EXPECT_THAT(numbers_in(link.take_output()), testing::ElementsAre(29, 0));
}

TEST(RobotLink, WithoutAnswerTriesThreeTimesThenWantsTheLineAnew) {
  RobotLink link{{}};
  link.up(0s);
  int syncs = 0;
  Time now{0};
  while (!link.take_reopen()) {
    for (const int number : numbers_in(link.take_output())) syncs += number == 0 ? 1 : 0;
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
    RobotLink link = checking_link(0s);
    (void)link.receive(settings({"Fred", "Pioneer", "p3dx"}, watchdog_ms), 10ms);
    return told_by(link);
  };
  EXPECT_THAT(told(2000), HasSubstr("only after 2000 ms"));
  EXPECT_THAT(told(0), HasSubstr("is off"));
  EXPECT_THAT(told(600), Not(HasSubstr("watchdog")));
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
