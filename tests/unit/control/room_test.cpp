// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/world/worlds.hpp"
#include "world_server/starts/room.hpp"
#include "world_server/world.hpp"

namespace caravan::world {
namespace {

TEST(Room, IsWhereNothingElseIs) {
  WorldConfig config = empty_world(10.0, 2);
  config.boxes.push_back({.centre_m = {2.0, 2.0}, .size_m = {1.0, 1.0}});
  const std::vector<Pose> poses{{0.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}};
  EXPECT_EQ(obstacle_at(config, poses, 1, {3.5, -3.0, 0.0}), "");
  EXPECT_EQ(obstacle_at(config, poses, 1, {0.1, 0.0, 0.0}), "") << "it does not stand in its own way";
  EXPECT_EQ(obstacle_at(config, poses, 1, {-2.1, 0.1, 0.0}), "robot 2 is there");
  EXPECT_EQ(obstacle_at(config, poses, 1, {2.6, 2.0, 0.0}), "something solid is there");
  EXPECT_EQ(obstacle_at(config, poses, 1, {4.9, 0.0, 0.0}), "a wall of the arena is there");
  EXPECT_EQ(obstacle_at(config, poses, 1, {99.0, 0.0, 0.0}), "a wall of the arena is there");
}

TEST(Place, PutsARobotAtRestWhereItIsAskedTo) {
  World world{empty_world(10.0, 2)};
  const std::vector<std::optional<Command>> drive(2, Command{1.0, 1.0, false});
  for (int i = 0; i < 30; ++i) world.advance(drive);
  ASSERT_EQ(world.place(1, {3.0, -3.0, 1.0}), "");
  EXPECT_NEAR(world.poses()[0].x_m, 3.0, 1e-12);
  EXPECT_NEAR(world.poses()[0].y_m, -3.0, 1e-12);
  EXPECT_NEAR(world.poses()[0].yaw_rad, 1.0, 1e-12);
  EXPECT_NEAR(world.sense(1).position.x_m, 3.0, 1e-12);
  world.advance(std::vector<std::optional<Command>>(2));
  EXPECT_NEAR(world.poses()[0].x_m, 3.0, 1e-3) << "its speed is gone";
  EXPECT_NEAR(world.poses()[0].yaw_rad, 1.0, 1e-3);
}

TEST(Place, LeavesTheRobotWhereItIsWhenThereIsNoRoom) {
  World world{empty_world(10.0, 2)};
  const Pose before = world.poses()[0];
  const std::uint64_t chain = world.chain();
  EXPECT_EQ(world.place(1, world.poses()[1]), "robot 2 is there");
  EXPECT_EQ(world.poses()[0].x_m, before.x_m);
  EXPECT_EQ(world.chain(), chain);
}

TEST(Place, StandsInTheDigest) {
  World moved{empty_world(10.0, 2)};
  World left{empty_world(10.0, 2)};
  ASSERT_EQ(moved.place(1, moved.poses()[0]), "");
  EXPECT_NE(moved.chain(), left.chain());
}

}  // namespace
}  // namespace caravan::world
