// SPDX-License-Identifier: Apache-2.0
// The emulated robot's end of the line. The packets of the host are written out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>
#include <utility>

#include "hardware_bridge/core/robot/body_watch.hpp"
#include "hardware_bridge/core/robot/gps_receiver.hpp"
#include "tests/unit/bridge/robot_bench.hpp"

namespace caravan::bridge {
namespace {

using arcos::Bytes;
using arcos::encode;
using arcos::Order;
using arcos::Sip;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Robot = RobotBench;

TEST_F(Robot, EchoesSyncsAndNamesItself) {
  robot_.connected(now_);
  say(encode(Order::kPulse));
  EXPECT_EQ(robot_.take_output(), encode(Order::kPulse));
  say(encode(Order::kOpen));
  EXPECT_EQ(robot_.take_output(), encode(Order::kOpen));
  say(encode(Order::kClose));
  const auto found = packets_.feed(robot_.take_output());
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(arcos::decode_names(found[0]), (arcos::Names{"caravan", "Pioneer", "p3dx"}));
  run(1s);
  EXPECT_THAT(sips_, IsEmpty()) << "not before OPEN";
  say(encode(Order::kOpen));
  run(1s);
  EXPECT_THAT(sips_, Not(IsEmpty()));
}

TEST_F(Robot, ExpectsPacketsOfWhoeverHasTheLineUntilTheConnectionIsOpen) {
  EXPECT_EQ(robot_.expects_packet_by(), std::nullopt) << "nobody";
  robot_.connected(now_);
  const Time patience = Microcontroller::kHostPatience;
  EXPECT_EQ(robot_.expects_packet_by(), now_ + patience);
  const Time connected = std::exchange(now_, now_ + 1s);
  say(Bytes{'G', 'E', 'T', ' ', '/', '\r', '\n'});
  EXPECT_EQ(robot_.expects_packet_by(), connected + patience) << "no packet";
  say(encode(Order::kPulse));
  EXPECT_EQ(robot_.expects_packet_by(), now_ + patience);
  shake_hands();
  EXPECT_EQ(robot_.expects_packet_by(), std::nullopt) << "an open connection may be silent";
  now_ += 1s;
  say(encode(Order::kClose));
  EXPECT_EQ(robot_.expects_packet_by(), now_ + patience);
  robot_.disconnected();
  EXPECT_EQ(robot_.expects_packet_by(), std::nullopt);
}

TEST_F(Robot, SendsASipEvery100Milliseconds) {
  open();
  run(2s);
  EXPECT_NEAR(static_cast<double>(sips_.size()), 20.0, 1.0);
}

TEST_F(Robot, FiresOneTransducerOfEachArrayEvery40Milliseconds) {
  senses_.sonar_range_m.fill(2.0);
  senses_.sonar_range_m[9] = std::numeric_limits<double>::infinity();
  robot_.sense(senses_, now_);
  open();
  run(1280ms);
  std::map<int, int> fired;
  for (const Sip& sip : sips_) {
    EXPECT_LE(sip.sonars.size(), 6U);
    for (const Sip::Sonar& sonar : sip.sonars) {
      ++fired[sonar.index];
      EXPECT_EQ(sonar.range_mm, sonar.index == 9 ? 5000 : 2000);
    }
  }
  EXPECT_EQ(fired.size(), kSonarCount);
  for (const auto& [index, times] : fired) EXPECT_NEAR(times, 4, 1) << index;
}

TEST_F(Robot, DrivesOnlyWithItsMotorsOn) {
  open();
  say(encode(Order::kEnable, 0));
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.3, 0.3)));
  run(1s);
  EXPECT_EQ(drive_.left_mps, 0.0);
  EXPECT_EQ(sips_.back().flags & arcos::kMotorsOn, 0);
  say(encode(Order::kEnable, 1));
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.3, 0.2)));
  run(1800ms);
  EXPECT_NEAR(drive_.left_mps, 0.3, 1e-9);
  EXPECT_NEAR(drive_.right_mps, 0.2, 1e-9);
  EXPECT_TRUE(sips_.back().moving);
}

TEST_F(Robot, SpeedsChangeByTheAccelerationThatWasSet) {
  open();
  say(encode(Order::kSetAcceleration, 1000));
  say(encode(Order::kSetAcceleration, -500));
  say(encode(Order::kSetMaxSpeed, 1000));
  say(encode(Order::kSpeed, 800));
  run(400ms);
  EXPECT_NEAR(drive_.left_mps, 0.4, 0.03);
  run(1s);
  EXPECT_DOUBLE_EQ(drive_.left_mps, 0.8);
  say(encode(Order::kStop));
  run(400ms);
  EXPECT_NEAR(drive_.left_mps, 0.6, 0.02);
  say(encode(Order::kEmergencyStop));
  run(20ms);
  EXPECT_EQ(drive_.left_mps, 0.0) << "at once";
}

TEST_F(Robot, TheWatchdogStopsTheWheelsAfterTwoSecondsAndTheNextPacketLetsThemGoOn) {
  open();
  say(encode(Order::kSetAcceleration, -2000));
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.4, 0.4)));
  run(1990ms);
  EXPECT_GT(drive_.left_mps, 0.3);
  run(300ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
  run(5s);
  EXPECT_EQ(drive_.left_mps, 0.0);
  say(encode(Order::kPulse));
  run(500ms);
  EXPECT_GT(drive_.left_mps, 0.1);
}

TEST_F(Robot, AHostThatComesBackAfterTheWatchdogAndSaysStopFirstStandsStill) {
  open();
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.4, 0.4)));
  run(4s);
  ASSERT_EQ(drive_.left_mps, 0.0);
  say(encode(Order::kStop));
  say(encode(Order::kPulse));
  run(1s);
  EXPECT_EQ(drive_.left_mps, 0.0);
}

TEST_F(Robot, APulseIsEnoughForTheWatchdog) {
  open();
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.4, 0.4)));
  for (int second = 0; second < 5; ++second) {
    say(encode(Order::kPulse));
    run(1s);
  }
  EXPECT_DOUBLE_EQ(drive_.left_mps, 0.4);
}

TEST_F(Robot, ReckonsByItsWheelsSlipOrNot) {
  open();
  say(encode(Order::kSetAcceleration, 2000));
  say(encode(Order::kPulse));
  say(encode(Order::kSpeed, 500));
  run(1900ms);
  arcos::Odometry host{*arcos::factors_of("p3dx")};
  double ahead = 0.0;
  for (const Sip& sip : sips_) ahead += host.follow(sip).ahead_m;
  EXPECT_NEAR(ahead, 0.5 * 1.9 - 0.5 * 0.5 * 0.25, 0.07);
  EXPECT_NEAR(sips_.back().left_mmps, 500, 2);
}

TEST_F(Robot, SpeedsAreByTheBodysClockHoweverItsFramesAreDelayed) {
  open();
  for (int frame = 0; frame < 100; ++frame) {
    const Time measured = frame * 32ms;
    senses_.left_wheel_rad = 0.3 * seconds(measured) / kRadius_m;
    senses_.right_wheel_rad = 0.2 * seconds(measured) / kRadius_m;
    senses_.measured = measured;
    now_ = frame / 5 * 160ms + frame % 5 * 1us;  // five at once
    robot_.sense(senses_, now_);
  }
  for (const Bytes& data : packets_.feed(robot_.take_output())) {
    if (auto sip = arcos::decode_sip(data)) sips_.push_back(*sip);
  }
  ASSERT_GT(sips_.size(), 10U);
  for (std::size_t i = 1; i < sips_.size(); ++i) {
    EXPECT_NEAR(sips_[i].left_mmps, 300, 1);
    EXPECT_NEAR(sips_[i].right_mmps, 200, 1);
    EXPECT_NEAR(*sips_[i].turn_rate, -174, 2);
  }
}

TEST_F(Robot, WheelsThatAreBlockedStall) {
  open();
  say(encode(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.3, 0.3)));
  run(1500ms, 0.0);
  EXPECT_EQ(sips_.back().stall_and_bumpers, arcos::kLeftStall | arcos::kRightStall);
  say(encode(Order::kStop));
  run(1600ms, 1.0);
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0);
}

TEST_F(Robot, TurnsToAHeading) {
  open();
  say(encode(Order::kSetAcceleration, 2000));
  say(encode(Order::kSetAcceleration, -2000));
  say(encode(Order::kHeading, 90));
  for (int second = 0; second < 6; ++second) {
    say(encode(Order::kPulse));
    run(1s);
  }
  EXPECT_NEAR(sips_.back().heading, 1024, 20);
  EXPECT_NEAR(sips_.back().left_mmps, 0, 5);
}

TEST_F(Robot, TheCompassIsClockwiseFromNorthInTwoDegrees) {
  open();
  senses_.yaw_WB_rad = 0.0;
  run(200ms);
  EXPECT_EQ(sips_.back().compass, 45);
  senses_.yaw_WB_rad = 0.5 * std::numbers::pi;
  run(200ms);
  EXPECT_EQ(sips_.back().compass % 180, 0);
}

TEST_F(Robot, TheStopButtonDisablesTheMotorsUntilTheyAreEnabledAgain) {
  open();
  say(encode(Order::kSpeed, 300));
  run(1s);
  robot_.press_stop(true);
  run(200ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
  EXPECT_EQ(sips_.back().flags, arcos::kStopPressed | arcos::kStopStalls | arcos::kSonarsOn);
  EXPECT_EQ(sips_.back().stall_and_bumpers, arcos::kLeftStall | arcos::kRightStall);
  say(encode(Order::kEnable, 1));
  run(200ms);
  EXPECT_EQ(sips_.back().flags & arcos::kMotorsOn, 0) << "not while it is in";
  robot_.press_stop(false);
  say(encode(Order::kEnable, 1));
  say(encode(Order::kSpeed, 300));
  run(1s);
  EXPECT_GT(drive_.left_mps, 0.2);
}

TEST_F(Robot, ItsGripperIsSeenInTheDigitalInputs) {
  open();
  run(200ms);
  EXPECT_EQ(*sips_.back().digital_in & arcos::kGripperNotOpen, 0);
  say(encode(Order::kGripper, arcos::kGripperCloses));
  senses_.holding = true;
  run(200ms);
  EXPECT_TRUE(drive_.gripper_closed);
  EXPECT_EQ(*sips_.back().digital_in, arcos::kGripperNotOpen | arcos::kInnerBeamBroken);
}

TEST_F(Robot, IgnoresWhatItDoesNotKnowAndSurvivesGarbage) {
  open();
  say(encode(arcos::Command{99, 5}));
  say(arcos::to_packet(Bytes{11, 0x77, 1}));
  say(Bytes(500, 0xfa));
  EXPECT_EQ(robot_.ignored_commands(), 2U);
  say(encode(Order::kPulse));
  run(1s);
  EXPECT_THAT(sips_, Not(IsEmpty()));
}

TEST_F(Robot, AClosedConnectionStopsEverything) {
  open();
  say(encode(Order::kSpeed, 300));
  run(1s);
  say(encode(Order::kClose));
  sips_.clear();
  run(500ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
  EXPECT_THAT(sips_, IsEmpty());
}

TEST(GpsReceiver, StandsWhereItsAntennaIsMounted) {
  const Point ahead = antenna_place({{3.0, 4.0}, 0.5 * std::numbers::pi}, {0.5, 0.25});
  EXPECT_NEAR(ahead.x_m, 2.75, 1e-9) << "to the left of a robot that looks north";
  EXPECT_NEAR(ahead.y_m, 4.5, 1e-9);
  const Point behind = antenna_place({{3.0, 4.0}, 0.0}, {-1.0, 0.0});
  EXPECT_NEAR(behind.x_m, 2.0, 1e-9);
  EXPECT_NEAR(behind.y_m, 4.0, 1e-9);
}

TEST(BodyWatch, TellsThatNobodyComesAfterASecondAndThenOnceAMinute) {
  BodyWatch watch;
  EXPECT_EQ(watch.look(999ms), std::nullopt);
  EXPECT_EQ(watch.next_look(), 1s);
  EXPECT_EQ(watch.look(1s), BodyWatch::News::kNoBody);
  EXPECT_EQ(watch.look(60s), std::nullopt);
  EXPECT_EQ(watch.look(61s), BodyWatch::News::kNoBody);
}

TEST(BodyWatch, TellsThatFramesHaveCeased) {
  BodyWatch watch;
  for (Time now = 0ms; now < 5s; now += 32ms) {
    watch.heard(now);
    EXPECT_EQ(watch.look(now), std::nullopt);
  }
  EXPECT_EQ(watch.look(5900ms), std::nullopt);
  EXPECT_EQ(watch.look(6s), BodyWatch::News::kSilent);
  EXPECT_EQ(watch.look(7s), std::nullopt);
}

TEST(GpsReceiver, TellsItsPlaceTenTimesASecondAndItsCourseWhileItMoves) {
  GpsReceiver receiver{{48.0, 11.0, 0.0}};
  receiver.sense({10.0, 0.0}, 0s);
  EXPECT_THAT(receiver.take_lines(0s), HasSubstr("$GPGGA,000000.00,4800.0000000,N,01100.0080"));
  EXPECT_THAT(receiver.take_lines(99ms), IsEmpty());
  receiver.sense({10.1, 0.0}, 100ms);
  EXPECT_THAT(receiver.take_lines(100ms), HasSubstr(",1.944,90.00,")) << "knots, east";
  receiver.sense({std::numeric_limits<double>::quiet_NaN(), 0.0}, 200ms);
  EXPECT_THAT(receiver.take_lines(200ms), HasSubstr(",V,"));
}

}  // namespace
}  // namespace caravan::bridge
