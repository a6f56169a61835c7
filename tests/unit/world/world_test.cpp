// SPDX-License-Identifier: Apache-2.0
#include "world_server/world.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include "build_paths.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/pure/random.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/shapes/scene.hpp"

namespace caravan::world {
namespace {

using Commands = std::vector<std::optional<Command>>;

WorldConfig shipped(const std::string& name) {
  return load_world_config(
      runtime::TomlDocument::load(std::string{CARAVAN_SOURCE_DIR} + "/deploy/scenarios/" + name + ".toml"));
}

/// All robots wander at random, and all their sensors are read. @return the hash chain
std::uint64_t wander(World& world, std::uint32_t robots, std::uint64_t seed, int steps) {
  pure::Random random{seed};
  Commands commands(robots);
  for (int i = 0; i < steps; ++i) {
    for (std::uint32_t robot = 1; robot <= robots; ++robot) {
      static_cast<void>(world.sense(robot));
      if (i % 20 != 0) continue;
      commands[robot - 1] = Command{random.uniform(-1.0, 1.6), random.uniform(-1.0, 1.6), random.chance(0.5)};
      if (random.chance(0.1)) commands[robot - 1].reset();
    }
    world.advance(commands);
  }
  return world.chain();
}

TEST(World, RepeatsItselfBitForBit) {
  const WorldConfig config = shipped("paper");
  World one{config};
  World two{config};
  EXPECT_EQ(wander(one, 15, 5, 600), wander(two, 15, 5, 600));
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(one.poses()[i].x_m, two.poses()[i].x_m);
    EXPECT_EQ(one.poses()[i].yaw_rad, two.poses()[i].yaw_rad);
  }
}

TEST(World, RepeatsItselfWhateverElseRunsInTheProcess) {
  const WorldConfig config = shipped("small");
  World alone{config};
  const std::uint64_t expected = wander(alone, 4, 5, 300);
  World beside{config};
  WorldConfig changed = config;
  changed.seed = 99;
  World other{changed};
  static_cast<void>(wander(other, 4, 7, 123));
  EXPECT_EQ(wander(beside, 4, 5, 300), expected);
}

TEST(World, RepeatsItselfOnSeveralThreadsAtOnce) {
  const WorldConfig config = shipped("small");
  World alone{config};
  const std::uint64_t expected = wander(alone, 4, 5, 200);
  std::array<std::uint64_t, 3> chains{};
  std::vector<std::thread> threads;
  for (std::uint64_t& chain : chains) {
    threads.emplace_back([&config, &chain] {
      World world{config};
      chain = wander(world, 4, 5, 200);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::uint64_t chain : chains) EXPECT_EQ(chain, expected);
}

TEST(World, AnotherSeedOrCommandGivesAnotherChain) {
  WorldConfig config = shipped("small");
  World one{config};
  World two{config};
  const std::uint64_t first = wander(one, 4, 5, 50);
  EXPECT_NE(first, wander(two, 4, 6, 50));
  config.seed = 2;
  World three{config};
  EXPECT_NE(first, wander(three, 4, 5, 50));
}

TEST(World, StopsTheWheelsOfARobotWithoutACommand) {
  World world{empty_world(20.0, 1)};
  Commands commands{Command{1.0, 1.0, false}};
  for (int i = 0; i < 60; ++i) world.advance(commands);
  commands[0].reset();
  for (int i = 0; i < 30; ++i) world.advance(commands);
  const Pose stopped = world.poses()[0];
  for (int i = 0; i < 60; ++i) world.advance(commands);
  EXPECT_LT(std::hypot(world.poses()[0].x_m - stopped.x_m, world.poses()[0].y_m - stopped.y_m), 1e-3);
}

TEST(World, CountsStepsAndTime) {
  World world{empty_world(20.0, 1)};
  for (int i = 0; i < 125; ++i) world.advance(Commands(1));
  EXPECT_EQ(world.step(), 125U);
  EXPECT_EQ(world.now(), std::chrono::seconds{4});
}

TEST(World, IsFinishedWhenTheTimeIsOver) {
  WorldConfig config = empty_world(20.0, 1);
  config.experiment.max_time_s = 0.32;
  World world{config};
  for (int i = 0; i < 9; ++i) world.advance(Commands(1));
  EXPECT_FALSE(world.finished());
  world.advance(Commands(1));
  EXPECT_TRUE(world.finished());
}

TEST(World, ARobotAtTheSourceTakesAnItemAndDeliversItAtTheDestination) {
  WorldConfig config = empty_world(20.0, 1);
  config.robots.source_m = {0.0, 0.0};
  config.robots.destination_m = {0.1, 0.0};
  config.experiment.items = 1;
  World world{config};
  world.advance(Commands{Command{0.0, 0.0, true}});
  ASSERT_EQ(world.item_events().size(), 1U);
  EXPECT_EQ(world.item_events()[0].kind, ItemEvent::Kind::kPickUp);
  EXPECT_TRUE(world.sense(1).holding);
  EXPECT_FALSE(world.finished());
  world.advance(Commands(1));  // without a command the gripper stays closed
  EXPECT_TRUE(world.sense(1).holding);
  EXPECT_TRUE(world.item_events().empty());
  world.advance(Commands{Command{0.0, 0.0, false}});
  EXPECT_EQ(world.items_delivered(), 1U);
  EXPECT_FALSE(world.sense(1).holding);
  EXPECT_TRUE(world.finished());
}

TEST(World, ReportsAContactOnceForAsLongAsItLasts) {
  WorldConfig config = empty_world(6.0, 1);
  World world{config};
  std::size_t episodes = 0;
  for (int i = 0; i < 400; ++i) {
    world.advance(Commands{Command{1.0, 1.0, false}});
    for (const ContactEpisode& episode : world.contacts()) {
      EXPECT_EQ(episode.robot, 1U);
      EXPECT_EQ(episode.other, 0U);
      ++episodes;
    }
  }
  EXPECT_EQ(episodes, 1U);
}

TEST(World, SensesItsTruePlaceWithoutNoise) {
  World world{shipped("small")};
  const Pose pose = world.poses()[2];
  const Sensors sensors = world.sense(3);
  EXPECT_EQ(sensors.position.x_m, pose.x_m);
  EXPECT_EQ(sensors.position.y_m, pose.y_m);
  EXPECT_EQ(sensors.yaw_rad, pose.yaw_rad);
  for (const double age : sensors.sonar_age_s) EXPECT_EQ(age, 0.0);
}

// With 1000 robots the shipped scenario gives each as much space as with 15.
TEST(World, HoldsAThousandRobots) {
  std::ostringstream text;
  text << std::ifstream{std::string{CARAVAN_SOURCE_DIR} + "/deploy/scenarios/scaling.toml"}.rdbuf();
  const std::string fifteen = text.str();
  const std::string thousand = std::regex_replace(fifteen, std::regex{"count = 15"}, "count = 1000");
  const WorldConfig config = load_world_config(runtime::TomlDocument::parse(thousand, "scaling.toml"));
  EXPECT_NEAR(config.arena_m[0] * config.arena_m[1], 2500.0 / 15.0 * 1000.0, 1e-6);
  World world{config};
  EXPECT_EQ(world.poses().size(), 1000U);
  static_cast<void>(wander(world, 1000, 1, 3));
  EXPECT_EQ(world.step(), 3U);
}

}  // namespace
}  // namespace caravan::world
