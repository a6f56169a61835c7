// SPDX-License-Identifier: Apache-2.0
// What stops the wheels of a robot behind a bridge, and how soon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/pure/random.hpp"
#include "tests/unit/bridge/bridge_loop.hpp"

namespace caravan::bridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(DrivingLoop, WheelsAreAtRest600MillisecondsAfterTheLastCommand) {
  agent_speaks_ = false;
  const Time rest = rest_after(5s);
  EXPECT_GT(rest, 400ms) << "four frames may be missed";
  EXPECT_LE(rest, 600ms - 150ms) << "what is left is for the way to the robot and for braking";
  run(200ms);  // the stop is logged with the robot's next packet
  EXPECT_THAT(told_, HasSubstr("no command for 400 ms: wheels stopped"));
  agent_speaks_ = true;
  run(1s);
  EXPECT_TRUE(moves_) << "and turn again with the next";
}

TEST_F(DrivingLoop, GpsLostStopsTheWheelsWithin600Milliseconds) {
  gps_works_ = false;
  EXPECT_LE(rest_after(5s), 600ms) << "the receiver says that it has no fix";
  EXPECT_THAT(told_, HasSubstr("position lost (GPS): wheels stopped"));
  run(200ms);
  EXPECT_TRUE(std::isnan(frames_.back().x_m)) << "the agent is told";
  gps_works_ = true;
  run(1s);
  EXPECT_TRUE(moves_);
  EXPECT_THAT(told_, HasSubstr("position known"));
}

TEST_F(DrivingLoop, AGpsThatFallsSilentStopsTheWheelsWithin600Milliseconds) {
  gps_speaks_ = false;
  EXPECT_LE(rest_after(5s), 600ms);
  gps_speaks_ = true;
  run(1s);
  EXPECT_TRUE(moves_);
}

TEST_F(DrivingLoop, ARobotThatSendsNothingIsStoppedWithin600Milliseconds) {
  robot_silent_ = true;
  EXPECT_LE(rest_after(5s), 600ms);
  EXPECT_THAT(told_, HasSubstr("robot silent: wheels told to stop"));
  run(2s);
  robot_silent_ = false;
  run(5s);
  EXPECT_TRUE(moves_) << "recovers without restart";
}

/// This holds wherever between two packets the robot falls silent, and however slow the agent is.
TEST_F(DrivingLoop, ARobotThatFallsSilentIsNotToldToLackCommandsToo) {
  for (unanswered_ = 1; unanswered_ <= 3; ++unanswered_) {
    for (Time delay{0}; delay < 300ms; delay += 10ms) {
      run(delay);
      robot_silent_ = true;
      run(1s);
      EXPECT_THAT(told_, HasSubstr("robot silent: wheels told to stop"));
      EXPECT_THAT(told_, Not(HasSubstr("no command"))) << unanswered_ << " " << in_seconds(delay);
      robot_silent_ = false;
      run(3s);
      ASSERT_TRUE(moves_);
      told_.clear();
    }
  }
}

TEST_F(DrivingLoop, ACableThatIsPulledAndPutBackNeedsNoRestart) {
  line_whole_ = false;
  bridge_.robot_down(now_);
  EXPECT_LE(rest_after(5s), 2s + 250ms + 20ms) << "nobody but the robot's own watchdog can do it";
  const std::size_t frames = frames_.size();
  run(3s);
  EXPECT_EQ(frames_.size(), frames) << "no frames without a robot";
  line_whole_ = true;
  robot_.connected(now_);
  bridge_.robot_up(now_);
  run(3s);
  EXPECT_TRUE(moves_);
}

TEST_F(DrivingLoop, ARobotAsDeliveredStopsTooLateWhenItsCableIsCutAndThatIsSaid) {
  EXPECT_THAT(told_, HasSubstr("its own watchdog stops it only after 2000 ms; set it to 300 ms"));
}

/// With the watchdog as docs/bring_your_robot.md requires it.
class LoopWithQuickWatchdog : public DrivingLoop {
 protected:
  LoopWithQuickWatchdog()
      : DrivingLoop{[] {
          RobotConfig config = robot_config();
          config.watchdog = 300ms;
          return config;
        }()} {}
};

TEST_F(LoopWithQuickWatchdog, ACableThatIsCutUnnoticedStopsTheWheelsWithin600Milliseconds) {
  EXPECT_THAT(told_, Not(HasSubstr("watchdog")));
  line_whole_ = false;
  EXPECT_LE(rest_after(5s), 600ms);
  EXPECT_THAT(told_, HasSubstr("robot silent: wheels told to stop"));
  run(3s);
  line_whole_ = true;
  robot_.connected(now_);
  bridge_.robot_up(now_);
  run(3s);
  EXPECT_TRUE(moves_) << "recovers without restart";
}

TEST_F(DrivingLoop, ARobotThatIsSwitchedOffAndOnIsFoundAgain) {
  robot_powered_ = false;
  run(4s);
  robot_.disconnected();
  robot_powered_ = true;
  run(5s);
  EXPECT_TRUE(moves_);
  EXPECT_THAT(told_, HasSubstr("connecting anew"));
}

TEST_F(DrivingLoop, GarbageBetweenThePacketsHarmsNothing) {
  pure::Random random{3};
  for (int i = 0; i < 500; ++i) {
    arcos::Bytes garbage;
    for (int byte = 0; byte < 30; ++byte) garbage.push_back(static_cast<std::uint8_t>(random.word()));
    bridge_.robot_says(garbage, now_);
    step();
  }
  EXPECT_TRUE(moves_);
  EXPECT_THAT(told_, HasSubstr("garbage on the robot's line"));
  for (const Frame& frame : frames_) {
    EXPECT_FALSE(std::abs(frame.x_m) >= 100.0) << "NaN before it is known";
    EXPECT_LT(std::abs(frame.left_wheel_rad), 1000.0);
  }
}

TEST_F(DrivingLoop, NothingButGarbageIsSilence) {
  robot_silent_ = true;
  for (int i = 0; i < 300; ++i) {
    bridge_.robot_says(arcos::Bytes(20, 0xfa), now_);
    step();
  }
  EXPECT_FALSE(moves_);
}

TEST_F(DrivingLoop, SaysWhatItWaitsForWhileTheWheelsStand) {
  agent_speaks_ = false;
  run(7s);
  EXPECT_THAT(told_, HasSubstr("waiting for: the agent's commands\n"));
  told_.clear();
  gps_works_ = false;
  line_whole_ = false;
  run(50s);
  EXPECT_THAT(told_, Not(HasSubstr("waiting for"))) << "once a minute";
  run(12s);
  EXPECT_THAT(told_, HasSubstr("waiting for: the robot, its position, the agent's commands\n"));
}

TEST_F(DrivingLoop, AnAgentThatIsGoneStopsAtOnce) {
  agent_speaks_ = false;
  bridge_.forget_wish(now_);
  EXPECT_LE(rest_after(5s), 300ms);
}

TEST_F(DrivingLoop, TheEndLeavesTheRobotSafe) {
  agent_speaks_ = false;
  bridge_.close();
  EXPECT_LE(rest_after(5s), 300ms);
  EXPECT_FALSE(robot_.is_open());
}

TEST_F(DrivingLoop, AfterAnEmergencyStopOnlyTheMotorsButtonLetsItDrive) {
  robot_.press_stop(true);
  EXPECT_LE(rest_after(5s), 300ms);
  run(5s);
  EXPECT_THAT(told_, HasSubstr("emergency stop pressed: wheels stopped"));
  robot_.press_stop(false);
  run(10s);
  EXPECT_FALSE(moves_) << "it was released, nobody asked it to drive";
  EXPECT_THAT(told_,
              HasSubstr("emergency stop released: the robot stands until somebody presses its MOTORS"));
  line_whole_ = false;
  bridge_.robot_down(now_);
  run(1s);
  line_whole_ = true;
  robot_.connected(now_);
  bridge_.robot_up(now_);
  run(5s);
  EXPECT_FALSE(moves_) << "another connection is no operator";
  robot_.switch_motors(true);
  run(1s);
  EXPECT_TRUE(moves_);
}

TEST_F(DrivingLoop, WheelCommandsAreZeroWhileTheEmergencyStopIsPressed) {
  // The robot reports a pressed stop but obeys nevertheless.
  arcos::Sip sip;
  sip.flags = arcos::kMotorsOn | arcos::kStopPressed;
  robot_silent_ = robot_hears_ = false;
  arcos::PacketFinder finder;
  int wheels = 0;
  bool enabled = true;
  for (int i = 0; i < 50; ++i) {
    now_ += 100ms;
    bridge_.robot_says(arcos::to_packet(encode(sip)), now_);
    bridge_.wish({0.5, 0.5, false}, now_, now_);
    for (const arcos::Bytes& data : finder.feed(bridge_.take_effects().to_robot)) {
      const auto command = arcos::decode_command(data);
      const int* number = std::get_if<int>(&command->argument);
      if (command->number == static_cast<int>(arcos::Order::kEnable)) enabled = *number != 0;
      if (command->number != static_cast<int>(arcos::Order::kWheelSpeeds)) continue;
      ++wheels;
      EXPECT_EQ(*number, 0) << i;
    }
  }
  EXPECT_GE(wheels, 5) << "told again and again";
  EXPECT_FALSE(enabled) << "motors off, so that somebody can switch them on";
}

TEST_F(DrivingLoop, MotorsSwitchedOffByHandStayOffUntilTheHandTurnsThemOn) {
  robot_.switch_motors(false);
  run(3s);
  EXPECT_FALSE(moves_);
  EXPECT_THAT(told_, HasSubstr("motors are disabled"));
  robot_.switch_motors(true);
  run(2s);
  EXPECT_TRUE(moves_);
}

}  // namespace
}  // namespace caravan::bridge
