// SPDX-License-Identifier: Apache-2.0
// Robots that are removed from the world and put back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/world/worlds.hpp"
#include "world_server/world.hpp"

namespace caravan::world {
namespace {

using Commands = std::vector<std::optional<Command>>;

constexpr Pose kWest{-3.0, 0.0, 0.0};
constexpr Pose kEast{3.0, 0.0, 0.0};

/// Robot 1 faces east towards robot 2, at this distance.
World facing_pair(double apart_m) {
  World world{empty_world(30.0, 2)};
  EXPECT_EQ(world.place(2, {9.0, 9.0, 0.0}), "");
  EXPECT_EQ(world.place(1, {0.0, 0.0, 0.0}), "");
  EXPECT_EQ(world.place(2, {apart_m, 0.0, 0.0}), "");
  return world;
}

double nearest_echo(World& world, std::uint32_t robot) {
  const Sensors sensors = world.sense(robot);
  return *std::min_element(sensors.sonar_range_m.begin(), sensors.sonar_range_m.end());
}

TEST(Presence, ARemovedRobotIsNowhere) {
  World world = facing_pair(2.0);
  EXPECT_LT(nearest_echo(world, 1), 2.0);
  EXPECT_EQ(world.remove(2), "");
  EXPECT_FALSE(world.is_present(2));
  EXPECT_TRUE(std::isnan(world.poses()[1].x_m));
  EXPECT_EQ(nearest_echo(world, 1), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(world.sense(2).position.x_m));
}

TEST(Presence, OthersDriveThroughThePlaceOfARemovedRobot) {
  const auto contacts = [](bool removed) {
    World world = facing_pair(1.2);
    if (removed) (void)world.remove(2);
    std::size_t episodes = 0;
    for (int i = 0; i < 60; ++i) {
      world.advance(Commands{Command{1.0, 1.0, false}, std::nullopt});
      episodes += world.contacts().size();
    }
    return episodes;
  };
  EXPECT_GT(contacts(false), 0U);
  EXPECT_EQ(contacts(true), 0U);
}

TEST(Presence, ASpawnedRobotStandsWhereItWasPut) {
  World world = facing_pair(2.0);
  EXPECT_EQ(world.remove(2), "");
  world.advance(Commands(2));
  EXPECT_EQ(world.spawn(2, {1.5, 0.0, 0.0}), "");
  EXPECT_TRUE(world.is_present(2));
  EXPECT_EQ(world.sense(2).position.x_m, world.poses()[1].x_m);
  EXPECT_NEAR(world.poses()[1].x_m, 1.5, 1e-9);
  EXPECT_LT(nearest_echo(world, 1), 1.5);
  world.advance(Commands(2));
  EXPECT_NEAR(world.poses()[1].x_m, 1.5, 1e-3) << "at rest";
}

TEST(Presence, SaysWhyNot) {
  World world = facing_pair(2.0);
  EXPECT_EQ(world.spawn(2, kEast), "robot 2 is in the world already");
  EXPECT_EQ(world.remove(2), "");
  EXPECT_EQ(world.remove(2), "robot 2 is not in the world");
  EXPECT_EQ(world.place(2, kEast), "robot 2 is not in the world");
  EXPECT_EQ(world.spawn(2, {0.1, 0.0, 0.0}), "robot 1 is there");
  EXPECT_EQ(world.spawn(2, {99.0, 0.0, 0.0}), "a wall of the arena is there");
  EXPECT_FALSE(world.is_present(2));
  EXPECT_EQ(world.remove(1), "it is the last one: a world without robots takes no step");
}

TEST(Presence, WhatARemovedRobotHeldCanBeDeliveredByOthers) {
  WorldConfig config = empty_world(20.0, 2);
  config.robots.source_m = {-3.0, 0.0};
  config.robots.destination_m = {-2.0, 0.0};
  config.experiment.items = 1;  // three in all: one more for each robot at the source
  World world{config};
  EXPECT_EQ(world.place(2, kWest), "");
  EXPECT_EQ(world.place(1, kEast), "");
  const auto grip = [&world](bool first, bool second) {
    world.advance(Commands{Command{0.0, 0.0, first}, Command{0.0, 0.0, second}});
    return world.item_events().size();
  };
  for (int time = 0; time < 5; ++time) {  // more often than there are items
    SCOPED_TRACE(time);
    EXPECT_EQ(grip(false, true), 1U);
    EXPECT_EQ(world.remove(2), "");
    EXPECT_EQ(grip(false, true), 0U) << "a robot that is not there takes nothing";
    EXPECT_EQ(world.spawn(2, kWest), "");
    EXPECT_FALSE(world.sense(2).holding);
  }
  EXPECT_EQ(grip(false, true), 1U);
  EXPECT_EQ(grip(false, false), 1U);
  EXPECT_EQ(world.items_delivered(), 1U);
}

TEST(Presence, GoesIntoTheChainAndRepeatsItself) {
  const auto chain = [](bool removed) {
    World world = facing_pair(1.0);
    for (int step = 0; step < 80; ++step) {
      if (removed && step == 20) (void)world.remove(2);
      if (removed && step == 60) (void)world.spawn(2, {0.0, 4.0, 0.0});
      for (std::uint32_t robot = 1; robot <= 2; ++robot) (void)world.sense(robot);
      world.advance(Commands{Command{0.5, 0.4, false}, std::nullopt});
    }
    return world.chain();
  };
  EXPECT_EQ(chain(true), chain(true));
  EXPECT_NE(chain(true), chain(false));
}

}  // namespace
}  // namespace caravan::world
