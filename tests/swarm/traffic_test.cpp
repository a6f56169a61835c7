// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/support/line_world.hpp"

namespace caravan::test {
namespace {

using agent::Config;
using agent::Point;
using agent::Sharing;

/// A street of 24 m by 5 m with the source at one end and the destination at the other.
Config street() {
  Config config;
  config.task.source = {-10.0, 0.0};
  config.task.destination = {10.0, 0.0};
  config.sharing.mode = Sharing::kNone;
  config.exploration.detection_radius_m = 30.0;
  return config;
}

LineWorld street_with_robots(const Config& config, int robots) {
  LineWorld world{config};
  world.add_walls(rectangle({0, 0}, 26, 6));
  for (int i = 0; i < robots; ++i) {
    const int row = i / 5;
    world.add_robot({-11.5 + 0.9 * (i % 5), -1.5 + 1.5 * row}, 0.3 * i);
  }
  return world;
}

TEST(Traffic, FifteenRobotsOnOnePathInBothDirectionsAllDeliver) {
  Config config = street();
  config.seed = 1;
  LineWorld world = street_with_robots(config, 15);
  world.run_for(1800.0);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_GE(world.delivered(i), 1U) << "robot " << i + 1;
  EXPECT_LT(world.longest_stand_s(), 300.0);
  EXPECT_LE(world.contacts(), 3);
}

TEST(Traffic, RobotsThatDoNotTellWhereTheyAreKeepThePapersRuleAndTouchMoreOften) {
  Config config = street();
  config.wait.tells_place = false;
  LineWorld world = street_with_robots(config, 15);
  world.run_for(300.0);
  EXPECT_GT(world.contacts(), 20);
}

TEST(Traffic, TwoRobotsThatMeetHeadOnPassEachOther) {
  LineWorld world{street()};
  world.add_walls(rectangle({0, 0}, 26, 6));
  world.add_robot({-8.0, 0.0}, 0.0);
  world.add_robot({8.0, 0.0}, 3.14);
  world.run_for(300.0);
  EXPECT_EQ(world.contacts(), 0);
  EXPECT_GE(world.delivered(0), 3U);
  EXPECT_GE(world.delivered(1), 3U);
  EXPECT_LT(world.longest_stand_s(), 30.0);
}

TEST(Traffic, DeadRobotsOnThePathAreObstaclesAndAreDrivenRound) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Config config = street();
    config.seed = seed;
    LineWorld world = street_with_robots(config, 2);
    world.run_for(300.0);
    const auto before = world.delivered(0) + world.delivered(1);
    for (const Point& at : {Point{-3.0, 0.0}, Point{2.0, 0.2}, Point{6.0, -0.3}}) world.add_dead(at);
    world.run_for(600.0);
    EXPECT_GE(world.delivered(0) + world.delivered(1), before + 10);
    EXPECT_LT(world.longest_stand_s(), 120.0);
  }
}

TEST(Traffic, AFullExchangingSwarmGetsOnePathAndDelivers) {
  Config config;
  config.task.source = {-9.0, -9.0};
  config.task.destination = {9.0, 9.0};
  config.sharing.mode = Sharing::kFull;
  config.sharing.starts = std::chrono::minutes{2};
  config.sharing.recontact_after = std::chrono::minutes{2};
  LineWorld world{config};
  world.add_walls(rectangle({0, 0}, 22, 22));
  world.add_walls(rectangle({0, 0}, 8, 8, 0.785));
  for (int i = 0; i < 8; ++i) {
    const int row = i / 4;
    world.add_robot({-10.0 + 1.0 * (i % 4), -10.0 + 1.2 * row}, 0.4 * i);
  }
  world.run_for(1500.0);
  int received = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_GE(world.delivered(i), 1U) << "robot " << i + 1;
    received += world.count(i, "received_path") + world.count(i, "merged_path");
  }
  EXPECT_GE(received, 1);
  EXPECT_LT(world.longest_stand_s(), 300.0);
}

}  // namespace
}  // namespace caravan::test
