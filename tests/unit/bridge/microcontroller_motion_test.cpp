// SPDX-License-Identifier: Apache-2.0
// How the emulated robot moves: setpoints, limits, motors, bumpers.
#include <gmock/gmock.h>

#include "tests/unit/bridge/robot_bench.hpp"

namespace caravan::bridge {
namespace {

using arcos::Order;

constexpr double kDegree = std::numbers::pi / 180.0;

class RobotInMotion : public RobotBench {
 protected:
  void SetUp() override { open(); }
};

TEST_F(RobotInMotion, MovesADistanceAheadAndBack) {
  say("FA FB 06 08 3B F4 01 FC 3C");  // MOVE 500
  run_with_pulses(5s);
  EXPECT_NEAR(travelled_m(), 0.5, 0.005);
  EXPECT_NEAR(turned_deg(), 0.0, 0.1);
  EXPECT_FALSE(sips_.back().moving);
  say("FA FB 06 08 1B F4 01 FC 1C");  // MOVE -500
  run_with_pulses(5s);
  EXPECT_NEAR(travelled_m(), 0.0, 0.005);
}

TEST_F(RobotInMotion, MovesAtItsMaximumWithItsAccelerations) {
  say(Order::kSetMaxSpeed, 200);
  say(Order::kSetAcceleration, 100);
  say(Order::kSetAcceleration, -400);
  say(Order::kMove, 1000);
  run(1s);
  EXPECT_NEAR(drive_.left_mps, 0.1, 0.003);
  run_with_pulses(7s);
  EXPECT_NEAR(travelled_m(), 1.0, 0.005);
  EXPECT_NEAR(fastest_mps_, 0.2, 1e-9);
}

TEST_F(RobotInMotion, ASpeedTakesThePlaceOfADistance) {
  say(Order::kMove, 3000);
  run(1s);
  say(Order::kSpeed, 0);
  run(2s);
  EXPECT_LT(travelled_m(), 0.5);
  EXPECT_FALSE(sips_.back().moving);
}

TEST_F(RobotInMotion, TurnsToAHeadingTheShorterWay) {
  say("FA FB 06 0C 3B 5A 00 66 3B");  // HEAD 90
  run_with_pulses(6s);
  EXPECT_NEAR(turned_deg(), 90.0, 0.5);
  EXPECT_NEAR(sips_.back().control, 1024, 1) << "the setpoint";
  EXPECT_LE(fastest_turn_radps_, 100.0 * kDegree + 1e-9);
  say(Order::kHeading, -100);
  run_with_pulses(6s);
  EXPECT_NEAR(turned_deg(), 260.0, 0.5);
  EXPECT_NEAR(travelled_m(), 0.0, 1e-6) << "on the spot";
}

TEST_F(RobotInMotion, TurnsByAnAngle) {
  say("FA FB 06 0D 1B 2D 00 3A 1B");  // DHEAD -45
  run_with_pulses(4s);
  EXPECT_NEAR(turned_deg(), -45.0, 0.5);
  say(Order::kHeadingFromHere, 90);
  run(300ms);
  say(Order::kHeadingFromSetpoint, 45);
  run_with_pulses(5s);
  EXPECT_NEAR(turned_deg(), 90.0, 0.5) << "-45 + 90, + 45 from there";
}

TEST_F(RobotInMotion, RotatesAsWithRvel) {
  say("FA FB 06 09 1B 14 00 1D 1B");  // ROTATE -20
  run(1s);
  EXPECT_NEAR(drive_.right_mps - drive_.left_mps, -20.0 * kDegree * 0.33, 1e-6);
  say(Order::kTurnRate, 30);
  run(1s);
  EXPECT_NEAR(drive_.right_mps - drive_.left_mps, 30.0 * kDegree * 0.33, 1e-6);
  EXPECT_EQ(sips_.back().turn_rate, 300);
}

TEST_F(RobotInMotion, TurnsNoFasterThanItsMaximumWhateverTheCommand) {
  say(Order::kSetMaxTurnRate, 40);
  say(Order::kSetTurnAcceleration, 600);
  say(Order::kTurnRate, 300);
  run_with_pulses(1s);
  say(Order::kHeadingFromHere, 170);
  run_with_pulses(1s);
  say(Order::kWheelSpeeds, arcos::wheel_speeds_argument(-0.5, 0.5));
  run_with_pulses(1s);
  EXPECT_NEAR(fastest_turn_radps_, 40.0 * kDegree, 1e-9);
}

TEST_F(RobotInMotion, WheelSpeedsKeepTheMaximumToo) {
  say(Order::kSetMaxSpeed, 150);
  say(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.5, 0.5));
  run(1900ms);
  EXPECT_NEAR(drive_.left_mps, 0.15, 1e-9);
}

TEST_F(RobotInMotion, TurningSpeedsUpAndDownByItsOwnAccelerations) {
  say(Order::kSetTurnAcceleration, 50);
  say(Order::kSetTurnAcceleration, -200);
  say(Order::kTurnRate, 80);
  run(1s);
  EXPECT_NEAR((drive_.right_mps - drive_.left_mps) / 0.33, 50.0 * kDegree, 0.02);
  run_with_pulses(1s);
  say(Order::kTurnRate, 0);
  run(200ms);
  EXPECT_NEAR((drive_.right_mps - drive_.left_mps) / 0.33, 40.0 * kDegree, 0.05);
}

TEST_F(RobotInMotion, TranslationAndRotationAreIndependent) {
  say(Order::kSpeed, 300);
  say(Order::kTurnRate, 20);
  run(1900ms);
  EXPECT_NEAR(0.5 * (drive_.left_mps + drive_.right_mps), 0.3, 1e-9);
  EXPECT_NEAR((drive_.right_mps - drive_.left_mps) / 0.33, 20.0 * kDegree, 1e-9);
  say(Order::kSpeed, 0);
  run(1900ms);
  EXPECT_NEAR((drive_.right_mps - drive_.left_mps) / 0.33, 20.0 * kDegree, 1e-9) << "turns on";
}

TEST_F(RobotInMotion, ASpeedOrTurnRateTakesThePlaceOfWheelSpeeds) {
  say(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.2, 0.1));
  run(1s);
  say(Order::kSpeed, 300);
  run(1900ms);
  EXPECT_NEAR(drive_.left_mps, 0.3, 1e-9);
  EXPECT_NEAR(drive_.right_mps, 0.3, 1e-9) << "no longer to the right";
  say(Order::kWheelSpeeds, arcos::wheel_speeds_argument(0.2, 0.1));
  run(1s);
  say(Order::kTurnRate, 20);
  run(1900ms);
  EXPECT_NEAR(drive_.left_mps + drive_.right_mps, 0.0, 1e-9) << "no longer ahead";
}

TEST_F(RobotInMotion, ANewOriginDoesNotTurnIt) {
  say(Order::kHeading, 90);
  run_with_pulses(6s);
  say("FA FB 03 07 00 07");  // SETO
  run_with_pulses(2s);
  EXPECT_NEAR(turned_deg(), 90.0, 0.5);
  EXPECT_EQ(sips_.back().x, 0);
  EXPECT_EQ(sips_.back().heading, 0);
}

TEST_F(RobotInMotion, WhatIsAskedForWithMotorsOffDoesNotCount) {
  for (const auto& [order, argument] : {std::pair{Order::kSpeed, 300},
                                        {Order::kMove, 1000},
                                        {Order::kTurnRate, 50},
                                        {Order::kHeading, 90},
                                        {Order::kWheelSpeeds, 0x0a0a}}) {
    SCOPED_TRACE(static_cast<int>(order));
    say(Order::kEnable, 0);
    say(order, argument);
    run_with_pulses(2s);
    EXPECT_EQ(sips_.back().stall_and_bumpers, 0) << "nothing stalls";
    say(Order::kEnable, 1);
    run_with_pulses(1s);
    EXPECT_EQ(drive_.left_mps, 0.0);
    EXPECT_EQ(drive_.right_mps, 0.0);
  }
  say(Order::kSpeed, 300);
  run(100ms);
  EXPECT_NEAR(drive_.left_mps, 0.03, 0.004) << "from rest";
}

TEST_F(RobotInMotion, TheStopButtonShowsAsAStallUnlessThatIsSwitchedOff) {
  robot_.press_stop(true);
  run(200ms);
  EXPECT_EQ(sips_.back().flags & 0x61, 0x60) << "pressed, stalls, motors off";
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0x0101);
  say(Order::kStopButtonStalls, 0);
  run(200ms);
  EXPECT_EQ(sips_.back().flags & 0x61, 0x20);
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0);
  robot_.press_stop(false);
  run(200ms);
  EXPECT_EQ(sips_.back().flags & 0x61, 0) << "the motors stay off";
}

RobotConfig with_bumpers() {
  RobotConfig config;
  config.front_bumpers = config.rear_bumpers = 5;
  return config;
}

class RobotWithBumpers : public RobotBench {
 protected:
  RobotWithBumpers() : RobotBench{with_bumpers()} {}
  void SetUp() override { open(); }
};

TEST_F(RobotWithBumpers, ShowsWhichSegmentsArePressed) {
  EXPECT_EQ(settings().front_bumpers, 5);
  robot_.press_bumpers(0b00101, 0b10000);
  say(Order::kIoRequest, 1);
  run(100ms);
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0b00101 << 9 | 0b10000 << 1);
  EXPECT_EQ(last(0xf0).at(3), 0b00101);
  EXPECT_EQ(last(0xf0).at(4), 0b10000);
  robot_.press_bumpers(0xff, 0);
  run(100ms);
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0b11111 << 9) << "no more than it has";
}

TEST_F(RobotWithBumpers, StopsAtAnObstacleAndDrivesAwayFromIt) {
  say(Order::kSpeed, 300);
  run(1s);
  robot_.press_bumpers(1, 0);
  run(200ms);
  EXPECT_EQ(drive_.left_mps, 0.0) << "at once";
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0x0301);
  say(Order::kSpeed, 300);
  run(500ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
  say(Order::kSpeed, -300);
  run(500ms);
  EXPECT_LT(drive_.left_mps, -0.1);
  EXPECT_EQ(sips_.back().stall_and_bumpers, 0x0200) << "no stall away from it";
}

TEST_F(RobotWithBumpers, DrivesOnWhereTheyAreSwitchedOff) {
  say(Order::kBumpStall, 2);  // only the rear bumpers
  say(Order::kSpeed, 300);
  robot_.press_bumpers(1, 0);
  run(1s);
  EXPECT_GT(drive_.left_mps, 0.2);
  say(Order::kBumpStall, 3);
  run(100ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
}

}  // namespace
}  // namespace caravan::bridge
