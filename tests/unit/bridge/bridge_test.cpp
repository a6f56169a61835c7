// SPDX-License-Identifier: Apache-2.0
// What a bridge reports to its agent and does for it, with an emulated robot at the other end of the line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/bridge/bridge_loop.hpp"

namespace caravan::bridge {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

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

TEST_F(Loop, RefusesClampsAndIgnores) {
  connect();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bridge_.wish({nan, 0.5, false}, frames_.back().stamp, now_);
  EXPECT_EQ(bridge_.refused_wishes(), 1U);
  wish_ = {99.0, 99.0, false};
  run(3s);
  EXPECT_GT(bridge_.clamped_wishes(), 0U);
  EXPECT_LE(frames_.back().left_wheel_rad - frames_[frames_.size() - 11].left_wheel_rad,
            1.61 / kLoopRadius_m);
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
