// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "hardware_bridge/core/pose/pose_fusion.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;

TEST(PoseFusion, KnowsNothingBeforeTheFirstFixAndTheFirstCompassReading) {
  PoseFusion fusion{{}};
  EXPECT_FALSE(fusion.pose(0s));
  fusion.fix({3.0, 4.0}, 0s);
  EXPECT_FALSE(fusion.pose(0s)) << "where, but not which way";
  fusion.read_compass(1.0);
  ASSERT_TRUE(fusion.pose(0s));
  EXPECT_DOUBLE_EQ(fusion.pose(0s)->p_WB.x_m, 3.0);
  EXPECT_DOUBLE_EQ(fusion.pose(0s)->yaw_WB_rad, 1.0);
}

TEST(PoseFusion, OdometryCarriesThePoseBetweenFixes) {
  PoseFusion fusion{{}};
  fusion.fix({0.0, 0.0}, 0s);
  fusion.read_compass(0.5 * std::numbers::pi);
  fusion.move({0.4, 0.0});
  EXPECT_NEAR(fusion.pose(100ms)->p_WB.y_m, 0.4, 1e-12);
  EXPECT_NEAR(fusion.pose(100ms)->p_WB.x_m, 0.0, 1e-12);
}

TEST(PoseFusion, APositionWithoutFixEndsAfterItsTime) {
  PoseFusion fusion{{}};
  fusion.read_compass(0.0);
  fusion.fix({1.0, 1.0}, 1s);
  EXPECT_TRUE(fusion.pose(1400ms));
  EXPECT_FALSE(fusion.pose(1401ms));
  fusion.fix({1.0, 1.0}, 2s);
  EXPECT_TRUE(fusion.pose(2s)) << "and is back with the next";
  fusion.lose_fix();
  EXPECT_FALSE(fusion.pose(2s)) << "the receiver knows it at once";
}

TEST(PoseFusion, WithoutGpsItReckonsFromTheStart) {
  FusionConfig config;
  config.has_gps = config.has_compass = false;
  config.start = {{-1.0, 2.0}, std::numbers::pi};
  PoseFusion fusion{config};
  fusion.move({0.5, 0.0});
  ASSERT_TRUE(fusion.pose(100h));
  EXPECT_NEAR(fusion.pose(100h)->p_WB.x_m, -1.5, 1e-12);
}

TEST(PoseFusion, AveragesWhatGpsAndCompassGetWrong) {
  pure::Random random{7};
  PoseFusion fusion{{}};
  double worst_m = 0.0;
  double worst_rad = 0.0;
  for (int step = 0; step < 600; ++step) {
    const Time now = 100ms * step;
    const double x = 0.03 * step;
    if (step > 0) fusion.move({0.03, 0.0});
    fusion.read_compass(0.1 * random.normal());
    fusion.fix({x + 0.2 * random.normal(), 0.2 * random.normal()}, now);
    if (step < 50) continue;
    const Pose pose = *fusion.pose(now);
    worst_m = std::max(worst_m, std::hypot(pose.p_WB.x_m - x, pose.p_WB.y_m));
    worst_rad = std::max(worst_rad, std::abs(pose.yaw_WB_rad));
  }
  EXPECT_LT(worst_m, 0.45) << "one fix alone is off by up to 0.8 m";
  EXPECT_LT(worst_rad, 0.12) << "one reading alone is off by up to 0.4";
}

TEST(PoseFusion, WithoutCompassTheWayBetweenFixesRightsTheHeading) {
  FusionConfig config;
  config.has_compass = false;
  config.start.yaw_WB_rad = 1.0;  // the true heading is along x
  PoseFusion fusion{config};
  fusion.fix({0.0, 0.0}, 0s);
  for (int step = 1; step <= 200; ++step) {
    fusion.move({0.05, 0.0});
    fusion.fix({0.05 * step, 0.0}, 100ms * step);
  }
  EXPECT_NEAR(fusion.pose(20s)->yaw_WB_rad, 0.0, 0.02);
  for (int step = 1; step <= 200; ++step) {
    fusion.move({-0.05, 0.0});
    fusion.fix({10.0 - 0.05 * step, 0.0}, 20s + 100ms * step);
  }
  EXPECT_NEAR(fusion.pose(40s)->yaw_WB_rad, 0.0, 0.02) << "driving backward turns nothing round";
}

TEST(PoseFusion, AnOdometryThatDriftsIsHeld) {
  PoseFusion fusion{{}};
  for (int step = 0; step < 1000; ++step) {
    const Time now = 100ms * step;
    if (step > 0) fusion.move({0.055, 0.002});  // the true values are 0.05 and 0
    fusion.read_compass(0.0);
    fusion.fix({0.05 * step, 0.0}, now);
  }
  const Pose pose = *fusion.pose(99900ms);
  EXPECT_NEAR(pose.p_WB.x_m, 0.05 * 999, 0.03);
  EXPECT_NEAR(pose.yaw_WB_rad, 0.0, 0.03);
}

TEST(PoseFusion, TheAntennaIsNotTheBase) {
  FusionConfig config;
  config.antenna_B = {-0.2, 0.1};
  PoseFusion fusion{config};
  fusion.read_compass(0.5 * std::numbers::pi);
  fusion.fix({1.0, 1.0}, 0s);
  EXPECT_NEAR(fusion.pose(0s)->p_WB.x_m, 1.1, 1e-12);
  EXPECT_NEAR(fusion.pose(0s)->p_WB.y_m, 1.2, 1e-12);
}

}  // namespace
}  // namespace caravan::bridge
