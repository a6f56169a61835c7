// SPDX-License-Identifier: Apache-2.0
// The bridge and an emulated robot at the two ends of a line, in time of the test's own: what is claimed in
// milliseconds is shown here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/robot/gps_receiver.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr ArenaPlace kArena{48.1, 11.6, 0.4};
constexpr double kRadius_m = 0.0975;
constexpr double kTrack_m = 0.33;

BridgeConfig bridge_config() {
  BridgeConfig config;
  config.arena = kArena;
  return config;
}
RobotConfig robot_config() {
  RobotConfig config;
  config.arena = kArena;
  return config;
}

class Loop : public ::testing::Test {
 protected:
  explicit Loop(const BridgeConfig& config = bridge_config(), const RobotConfig& robot = robot_config())
      : bridge_{config}, robot_{robot} {}

  void connect() {
    robot_.connected(now_);
    bridge_.robot_up(now_);
    run(2s);
  }
  void run(Time span) {
    for (const Time end = now_ + span; now_ < end;) step();
  }
  /// Ten milliseconds of both ends and of the body between.
  void step() {
    now_ += 10ms;
    const BodyDrive drive = robot_powered_ ? robot_.drive(now_) : BodyDrive{};
    moves_ = drive.left_mps != 0.0 || drive.right_mps != 0.0;
    move_body(drive);
    if (robot_powered_) robot_.sense(senses_, now_);
    gps_.sense(gps_works_ ? place_ : Point{std::nan(""), 0.0}, now_);
    const std::string lines = gps_.take_lines(now_);
    if (gps_speaks_) bridge_.gps_says(bytes_of(lines), now_);
    if (robot_powered_ && !robot_silent_) pass_to_host(robot_.take_output());
    if (agent_speaks_ && !frames_.empty()) bridge_.wish(wish_, frames_.back().stamp, now_);
    bridge_.tick(now_);
    Bridge::Effects effects = bridge_.take_effects();
    if (line_whole_ && robot_powered_ && !effects.to_robot.empty()) robot_.receive(effects.to_robot, now_);
    for (const Frame& frame : effects.frames) frames_.push_back(frame);
    for (const Notice& notice : effects.notices) told_ += notice.text + "\n";
    if (effects.reopen_robot && line_whole_) {
      robot_.connected(now_);
      bridge_.robot_up(now_);
    }
  }
  /// When its wheels have come to rest.
  [[nodiscard]] Time rest_after(Time patience) {
    const Time began = now_;
    while (now_ - began < patience && (moves_ || now_ == began)) step();
    return now_ - began;
  }
  static std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  }
  void pass_to_host(const arcos::Bytes& bytes) {
    if (line_whole_ && !bytes.empty()) bridge_.robot_says(bytes, now_);
  }
  void move_body(const BodyDrive& drive) {
    senses_.left_wheel_rad += 0.01 * drive.left_mps / kRadius_m;
    senses_.right_wheel_rad += 0.01 * drive.right_mps / kRadius_m;
    const double turned = 0.01 * (drive.right_mps - drive.left_mps) / kTrack_m;
    const double half_way = senses_.yaw_WB_rad + 0.5 * turned;
    place_.x_m += 0.005 * (drive.left_mps + drive.right_mps) * std::cos(half_way);
    place_.y_m += 0.005 * (drive.left_mps + drive.right_mps) * std::sin(half_way);
    senses_.yaw_WB_rad = wrapped(senses_.yaw_WB_rad + turned);
  }

  Bridge bridge_;
  Microcontroller robot_;
  GpsReceiver gps_{kArena};
  Time now_{0};
  BodySenses senses_;
  Point place_{3.0, -2.0};
  Wish wish_;
  bool moves_ = false;
  bool line_whole_ = true;
  bool robot_powered_ = true;
  bool robot_silent_ = false;
  bool gps_speaks_ = true;
  bool gps_works_ = true;
  bool agent_speaks_ = true;
  std::vector<Frame> frames_;
  std::string told_;
};

class DrivingLoop : public Loop {
 protected:
  explicit DrivingLoop(const RobotConfig& robot = robot_config()) : Loop{bridge_config(), robot} {}
  void SetUp() override {
    connect();
    wish_ = {0.5, 0.5, false};
    run(2s);
    ASSERT_TRUE(moves_);
  }
};

TEST_F(Loop, GivesAFrameForEachSip) {
  connect();
  frames_.clear();
  run(5s);
  EXPECT_NEAR(static_cast<double>(frames_.size()), 50.0, 2.0);
  for (std::size_t i = 1; i < frames_.size(); ++i) EXPECT_GT(frames_[i].stamp, frames_[i - 1].stamp);
}

TEST_F(Loop, FramesSayWhereTheRobotIsInTheArena) {
  senses_.yaw_WB_rad = 1.2;
  connect();
  wish_ = {0.4, 0.5, false};
  run(20s);
  EXPECT_NEAR(frames_.back().x_m, place_.x_m, 0.1);
  EXPECT_NEAR(frames_.back().y_m, place_.y_m, 0.1);
  EXPECT_NEAR(wrapped(frames_.back().yaw_rad - senses_.yaw_WB_rad), 0.0, 0.06);
  EXPECT_NEAR(frames_.back().left_wheel_rad, senses_.left_wheel_rad, 1.0);
  EXPECT_NEAR(frames_.back().right_wheel_rad, senses_.right_wheel_rad, 1.0);
  EXPECT_GT(frames_.back().right_wheel_rad, frames_.back().left_wheel_rad);
}

TEST_F(Loop, SonarsAreNeverOlderThanARound) {
  senses_.sonar_range_m.fill(1.25);
  connect();
  run(1s);
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    EXPECT_DOUBLE_EQ(frames_.back().sonar_range_m[i], 1.25) << i;
    EXPECT_LE(frames_.back().sonar_age_s[i], 0.4) << i;
  }
}

TEST_F(DrivingLoop, WheelsStop600MillisecondsAfterTheLastCommand) {
  agent_speaks_ = false;
  const Time rest = rest_after(5s);
  EXPECT_GT(rest, 600ms);
  EXPECT_LE(rest, 600ms + 20ms);
  EXPECT_THAT(told_, HasSubstr("no command for 600 ms: wheels stopped"));
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
  EXPECT_THAT(told_, HasSubstr("its own watchdog stops it after 2000 ms only; set it to 300 ms"));
}

/// With the watchdog as docs/bring_your_robot.md wants it.
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
    EXPECT_LT(std::abs(frame.x_m), 100.0);
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

TEST_F(Loop, RefusesClampsAndIgnores) {
  connect();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bridge_.wish({nan, 0.5, false}, frames_.back().stamp, now_);
  EXPECT_EQ(bridge_.refused_wishes(), 1U);
  wish_ = {99.0, 99.0, false};
  run(3s);
  EXPECT_GT(bridge_.clamped_wishes(), 0U);
  EXPECT_LE(frames_.back().left_wheel_rad - frames_[frames_.size() - 11].left_wheel_rad, 1.61 / kRadius_m);
  const std::uint64_t stale = bridge_.stale_wishes();
  bridge_.wish({0.1, 0.1, false}, now_ - 700ms, now_);
  bridge_.wish({0.1, 0.1, false}, now_ + 10s, now_);
  EXPECT_EQ(bridge_.stale_wishes(), stale + 2);
}

TEST_F(Loop, MovesNothingBeforeItKnowsWhereItIs) {
  gps_speaks_ = false;
  wish_ = {0.5, 0.5, false};
  connect();
  run(3s);
  EXPECT_FALSE(moves_);
  EXPECT_THAT(frames_, Not(IsEmpty()));
  EXPECT_TRUE(std::isnan(frames_.back().x_m));
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

TEST_F(DrivingLoop, ReportsTheStopButtonAndGoesOnWhenItComesOut) {
  robot_.press_stop(true);
  run(500ms);
  EXPECT_FALSE(moves_);
  EXPECT_THAT(told_, HasSubstr("emergency stop pressed"));
  robot_.press_stop(false);
  run(2s);
  EXPECT_TRUE(moves_);
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

TEST_F(Loop, TheGripperIsTheRobots) {
  connect();
  wish_.gripper_closed = true;
  run(500ms);
  EXPECT_TRUE(robot_.drive(now_).gripper_closed);
  EXPECT_FALSE(frames_.back().holding);
  senses_.holding = true;
  run(200ms);
  EXPECT_TRUE(frames_.back().holding);
  wish_.gripper_closed = false;
  run(500ms);
  EXPECT_FALSE(robot_.drive(now_).gripper_closed);
}

class LoopWithoutGripper : public Loop {
 protected:
  LoopWithoutGripper()
      : Loop{[] {
          BridgeConfig config = bridge_config();
          config.has_gripper = false;
          config.source_W = {3.0, -2.0};
          return config;
        }()} {}
};

TEST_F(LoopWithoutGripper, ItIsImaginedByPosition) {
  connect();
  wish_.gripper_closed = true;
  run(500ms);
  EXPECT_TRUE(frames_.back().holding) << "closed at the source";
  wish_.gripper_closed = false;
  run(500ms);
  EXPECT_FALSE(frames_.back().holding);
  place_ = {30.0, 30.0};
  run(2s);
  wish_.gripper_closed = true;
  run(500ms);
  EXPECT_FALSE(frames_.back().holding) << "closed elsewhere";
}

}  // namespace
}  // namespace caravan::bridge
