// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/communication.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <map>

#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/frames/text.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr Time kStep = 32ms;

/// The frames as their receivers get them.
std::vector<ReceivedFrame> arrive(const std::vector<Frame>& frames) {
  std::vector<ReceivedFrame> heard;
  for (const Frame& frame : frames) heard.push_back({.channel = frame.channel, .bytes = frame.bytes});
  return heard;
}

std::string text_of(const Frame& frame) {
  return std::visit(pure::Overload{[](const auto& message) { return to_text(message); },
                                   [](DecodeError) { return std::string{"?"}; }},
                    decode(frame.bytes));
}

Path straight(std::size_t points) {
  Path path;
  for (std::size_t index = 0; index < points; ++index) path.push_back(on_grid({double(index), -1.5}));
  return path;
}

/// Robots within radio range of each other, without losses, with one step of latency.
struct CommunicationTest : testing::Test {
  struct Robot {
    Communication communication;
    Path path;
    AirOutputs out;
    std::vector<Exchange> ended;
    std::vector<Path> received;
    std::vector<std::string> sent;  // without WAITs
  };
  CommunicationSettings config;
  std::map<std::uint16_t, Robot> robots;
  Time now = 20min;

  Robot& add(std::uint16_t id, Path path) {
    CommunicationSettings own = config;
    own.id = RobotId{id};
    return robots.emplace(id, Robot{Communication{own}, std::move(path), {}, {}, {}, {}}).first->second;
  }
  void step(const std::vector<ReceivedFrame>& extra = {}) {
    std::map<std::uint16_t, std::vector<ReceivedFrame>> heard;
    for (const auto& [to, receiver] : robots) {
      for (const auto& [from, sender] : robots) {
        for (const Frame& frame : sender.out.frames) {
          if (from == to || frame.channel != receiver.out.tuned) continue;
          heard[to].push_back({.channel = frame.channel, .bytes = frame.bytes});
        }
      }
      heard[to].insert(heard[to].end(), extra.begin(), extra.end());
    }
    now += kStep;
    for (auto& [id, robot] : robots) take(robot, heard[id]);
  }
  void take(Robot& robot, const std::vector<ReceivedFrame>& heard) const {
    robot.out = robot.communication.step({.now = now, .heard = heard, .own_path = robot.path});
    robot.ended.insert(robot.ended.end(), robot.out.ended.begin(), robot.out.ended.end());
    if (robot.out.received) robot.received.push_back(*robot.out.received);
    for (const Frame& frame : robot.out.frames) {
      if (!text_of(frame).starts_with("WAIT")) robot.sent.push_back(text_of(frame));
    }
  }
  void run(int steps) {
    for (; steps > 0; --steps) step();
  }
};

TEST_F(CommunicationTest, TwoRobotsExchangeTheirPathsInAFewSteps) {  // P-40
  Robot& three = add(3, straight(45));
  Robot& seven = add(7, straight(10));
  run(30);
  EXPECT_THAT(three.received, ElementsAre(straight(10)));
  EXPECT_THAT(seven.received, ElementsAre(straight(45)));
  ASSERT_THAT(three.ended, SizeIs(1));
  ASSERT_THAT(seven.ended, SizeIs(1));
  EXPECT_TRUE(three.ended[0].completed && seven.ended[0].completed);
  EXPECT_TRUE(seven.ended[0].primary);
  EXPECT_FALSE(three.ended[0].primary);
  EXPECT_EQ(three.ended[0].session, seven.ended[0].session);
  EXPECT_LE(three.ended[0].ended - three.ended[0].began, 10 * kStep);
  EXPECT_LE(seven.ended[0].ended - seven.ended[0].began, 10 * kStep);
  EXPECT_FALSE(three.out.stand_still || seven.out.stand_still);
  EXPECT_EQ(three.out.tuned, kCommonChannel);
}

TEST_F(CommunicationTest, TheConversationIsThePapers) {  // P-31
  Robot& three = add(3, straight(2));
  Robot& seven = add(7, {});
  run(20);
  EXPECT_THAT(seven.sent, ElementsAre("ACCEPT_7-3", "PATH_7-3_-/0", "PATH_7-3_-/0", "END_7-3", "END_7-3"));
  EXPECT_THAT(three.sent,
              ElementsAre("ACCEPTACK_3-7", "ACCEPTACK_3-7", "PATH_3-7_0..1/2", "PATH_3-7_0..1/2", "END_3-7"));
}

TEST_F(CommunicationTest, WaitGoesOutFirstInEveryStepEvenInASession) {  // P-1, P-2
  Robot& three = add(3, straight(300));
  add(7, straight(300));
  std::vector<std::string> waits;
  for (int count = 0; count < 30; ++count) {
    step();
    ASSERT_FALSE(three.out.frames.empty());
    EXPECT_EQ(three.out.frames[0].channel, kCommonChannel);
    waits.push_back(text_of(three.out.frames[0]));
    EXPECT_LE(three.out.frames.size(), 2U);
  }
  EXPECT_EQ(waits.front(), "WAIT_3_TRANSPORT");
  EXPECT_EQ(waits[10], "WAIT_3_BUSY");
}

TEST_F(CommunicationTest, WaitGoesOutOncePerWaitPeriod) {  // P-1
  config.wait.period = 1s;
  Robot& three = add(3, {});
  int waits = 0;
  for (int count = 0; count < 313; ++count) {
    step();
    waits += static_cast<int>(three.out.frames.size());
  }
  EXPECT_EQ(waits, 10);
}

/// The number of WAITs that robot 3 sends when its position in each step is `place(step)`; if `near`, it
/// receives a WAIT of robot 7 in each step.
int waits_of_a_robot(CommunicationSettings config, bool near, const std::function<Whereabouts(int)>& place) {
  config.id = RobotId{3};
  Communication communication{config};
  const Path none;
  int waits = 0;
  for (int step = 0; step < 312; ++step) {
    std::vector<ReceivedFrame> heard;
    if (near) {
      heard.push_back({.channel = kCommonChannel, .bytes = encode(Wait{RobotId{7}, Mode::kExplore, {}, {}})});
    }
    const AirOutputs out = communication.step(
        {.now = step * kStep, .heard = heard, .own_path = none, .whereabouts = place(step)});
    waits += static_cast<int>(out.frames.size());
  }
  return waits;
}

TEST_F(CommunicationTest, ARobotThatDoesNotMoveAsItToldTellsAnewWhenAnotherIsNear) {  // P-14
  config.wait.period = 1s;
  // 1 m/s to and fro: the robot turns back every two seconds, half way between two WAITs.
  const auto to_and_fro = [](int step) {
    const int phase = (step + 16) % 126;
    const int x_mm = 32 * (phase < 63 ? phase : 126 - phase);
    return Whereabouts{{x_mm, 0}, 0, static_cast<std::int16_t>(phase < 63 ? 1000 : -1000), 0};
  };
  const auto straight_on = [](int step) { return Whereabouts{{32 * step, 0}, 0, 1000, 0}; };
  const auto turns_unsaid = [](int step) {
    return Whereabouts{{0, 0}, static_cast<std::int16_t>(20 * (step % 157)), 0, 0};
  };
  EXPECT_EQ(waits_of_a_robot(config, true, straight_on), 10) << "it is where it said that it would be";
  EXPECT_GE(waits_of_a_robot(config, true, to_and_fro), 11) << "it is not, after each turn";
  EXPECT_GE(waits_of_a_robot(config, true, turns_unsaid), 18) << "0.3 rad take 16 steps";
  EXPECT_EQ(waits_of_a_robot(config, false, to_and_fro), 10) << "there is nobody to tell";
}

TEST_F(CommunicationTest, StandsStillAndIsTunedAwayOnlyWhileTheExchangeLasts) {  // P-5
  Robot& three = add(3, straight(100));
  Robot& seven = add(7, straight(100));
  step();
  EXPECT_FALSE(three.out.stand_still);
  step();
  EXPECT_TRUE(three.out.stand_still && seven.out.stand_still);
  run(4);
  EXPECT_EQ(three.out.tuned.value, 25U);  // 1 + (7 * 6 / 2 + 3)
  EXPECT_EQ(seven.out.tuned, three.out.tuned);
  run(20);
  EXPECT_FALSE(three.out.stand_still || seven.out.stand_still);
}

TEST_F(CommunicationTest, NobodyPairsBeforeSharingStarts) {  // P-21
  now = config.sharing.starts - 10 * kStep;
  Robot& three = add(3, straight(10));
  add(7, straight(10));
  run(9);
  EXPECT_FALSE(three.out.stand_still);
  run(2);
  EXPECT_TRUE(three.out.stand_still);
}

TEST_F(CommunicationTest, TheSamePartnerIsNotMetAgainForTenMinutes) {  // P-22
  Robot& three = add(3, straight(10));
  add(7, straight(10));
  run(static_cast<int>(599s / kStep));
  EXPECT_THAT(three.ended, SizeIs(1));
  run(static_cast<int>(3s / kStep));
  EXPECT_THAT(three.ended, SizeIs(2));
}

TEST_F(CommunicationTest, InPartialModeTheGiverReceivesNothing) {  // P-20, P-44
  config.sharing.mode = Sharing::kPartial;
  Robot& three = add(3, straight(45));
  Robot& seven = add(7, {});
  run(30);
  EXPECT_THAT(seven.received, ElementsAre(straight(45)));
  EXPECT_THAT(three.received, SizeIs(0));
  EXPECT_TRUE(three.ended.at(0).completed);
}

TEST_F(CommunicationTest, InPartialModeARobotThatFindsItsPathMeanwhileKeepsIt) {  // P-44
  config.sharing.mode = Sharing::kPartial;
  Robot& three = add(3, straight(45));
  Robot& seven = add(7, {});
  run(2);
  seven.path = straight(5);
  run(30);
  EXPECT_TRUE(three.ended.at(0).completed);
  EXPECT_THAT(seven.received, SizeIs(0));
  EXPECT_THAT(three.received, SizeIs(0));
}

TEST_F(CommunicationTest, InACrowdEverybodyMeetsEverybodySoonAndOneAtATime) {  // P-33
  for (std::uint16_t id = 1; id <= 8; ++id) add(id, straight(30));
  for (int count = 0; count < static_cast<int>(60s / kStep); ++count) {
    step();
    for (const auto& [id, robot] : robots) EXPECT_LE(robot.out.ended.size(), 2U);
  }
  for (const auto& [id, robot] : robots) {
    EXPECT_THAT(robot.received, SizeIs(7)) << "robot " << id;
    Time standing{0};
    for (const Exchange& exchange : robot.ended) standing += exchange.ended - exchange.began;
    EXPECT_LT(standing, 6s) << "robot " << id;
  }
}

TEST_F(CommunicationTest, RobotsThatHaveMetDoNotRejectEachOtherForEver) {  // P-33
  Robot& three = add(3, straight(10));
  Robot& seven = add(7, straight(10));
  run(20);
  three.sent.clear();
  seven.sent.clear();
  run(3000);
  EXPECT_THAT(three.sent, SizeIs(0));
  EXPECT_THAT(seven.sent, SizeIs(0));
}

TEST_F(CommunicationTest, APartnerThatForgotIsRejectedAtOnceAndAtMostOnceASecond) {  // P-33, P-34
  Robot& three = add(3, straight(10));
  add(7, straight(10));
  run(30);
  robots.erase(7);
  Robot& restarted = add(7, straight(10));
  three.sent.clear();
  run(200);
  EXPECT_THAT(three.sent, ElementsAre("REJECT_3-7"));
  ASSERT_THAT(restarted.ended, SizeIs(1));
  EXPECT_FALSE(restarted.ended[0].completed);
  EXPECT_LE(restarted.ended[0].ended - restarted.ended[0].began, 3 * kStep);
}

TEST_F(CommunicationTest, APartnerThatDiesInTheSessionCostsTwoSeconds) {  // P-32
  Robot& three = add(3, straight(300));
  add(7, straight(300));
  run(8);
  robots.erase(7);
  run(100);
  ASSERT_THAT(three.ended, SizeIs(1));
  EXPECT_FALSE(three.ended[0].completed);
  EXPECT_LE(three.ended[0].ended - three.ended[0].began, 2s + 10 * kStep);
  EXPECT_THAT(three.received, SizeIs(0));
}

TEST_F(CommunicationTest, KnowsARobotIsNearAndRemembersItForAMomentWhileTunedAway) {  // P-4
  Robot& three = add(3, straight(300));
  EXPECT_FALSE(three.out.robot_near);
  add(7, straight(300));
  run(2);
  EXPECT_TRUE(three.out.robot_near);
  run(5);
  EXPECT_TRUE(three.out.robot_near);
  robots.erase(7);
  run(3);
  EXPECT_TRUE(three.out.robot_near);
  run(10);
  EXPECT_FALSE(three.out.robot_near);
}

TEST_F(CommunicationTest, PresenceWorksInModeNone) {  // P-1, P-4, P-20
  config.sharing.mode = Sharing::kNone;
  Robot& three = add(3, straight(10));
  add(7, straight(10));
  run(100);
  EXPECT_TRUE(three.out.robot_near);
  EXPECT_THAT(three.ended, SizeIs(0));
  EXPECT_THAT(three.sent, SizeIs(0));
}

TEST_F(CommunicationTest, TellsWhereItIsInItsWaitAndHandsOnWhatOthersTell) {  // P-9
  const Whereabouts place{{-21500, -22000}, 1571, 975, -300};
  Communication three{CommunicationSettings{.id = RobotId{3}}};
  Communication seven{CommunicationSettings{.id = RobotId{7}}};
  const Path none;
  const AirOutputs told = three.step({.now = now, .heard = {}, .own_path = none, .whereabouts = place});
  const AirOutputs heard = seven.step({.now = now, .heard = arrive(told.frames), .own_path = none});
  EXPECT_EQ(text_of(told.frames.front()), "WAIT_3_EXPLORE");
  ASSERT_THAT(heard.robots, SizeIs(1));
  EXPECT_EQ(heard.robots[0].from, RobotId{3});
  EXPECT_EQ(heard.robots[0].whereabouts, place);
  const AirOutputs answer = three.step({.now = now + kStep, .heard = arrive(heard.frames), .own_path = none});
  ASSERT_THAT(answer.robots, SizeIs(1));
  EXPECT_FALSE(answer.robots[0].whereabouts) << "who does not know where it is says so by saying nothing";
}

TEST_F(CommunicationTest, CountsForeignBytesAndIgnoresItsOwnName) {  // P-12
  Robot& three = add(3, straight(10));
  step({{kCommonChannel, {1, 2, 3}},
        {kCommonChannel, {}},
        {kCommonChannel, encode(Wait{RobotId{3}, Mode::kTransport, Engagement::kFree, {}})}});
  EXPECT_EQ(three.out.malformed, 2U);
  EXPECT_FALSE(three.out.robot_near);
  EXPECT_FALSE(three.out.stand_still);
}

TEST_F(CommunicationTest, WorksAtTheSmallestMtu) {  // P-13
  config.air.mtu_bytes = 32;
  Robot& three = add(3, straight(45));
  Robot& seven = add(7, straight(10));
  for (int count = 0; count < 60; ++count) {
    step();
    for (const auto& [id, robot] : robots) {
      for (const Frame& frame : robot.out.frames) EXPECT_LE(frame.bytes.size(), 32U);
    }
  }
  EXPECT_THAT(three.received, ElementsAre(straight(10)));
  EXPECT_THAT(seven.received, ElementsAre(straight(45)));
}

}  // namespace
}  // namespace caravan::agent
