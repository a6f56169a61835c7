// SPDX-License-Identifier: Apache-2.0
#include "world_server/config/world_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "build_paths.hpp"

namespace caravan::world {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A whole scenario in which some lines can be replaced.
struct Scenario {
  std::string robots = "source_m = [-4.0, -4.0]\ndestination_m = [4.0, 4.0]\n";
  std::string experiment = "items = 4\n";
  std::string world = "arena_m = [12.0, 12.0]\nstart_low_m = [-5.0, -5.0]\nstart_high_m = [-3.0, -3.0]\n";

  [[nodiscard]] WorldConfig load() const {
    const std::string text =
        "[robots]\n" + robots + "[experiment]\n" + experiment + "[radio]\n[algorithm]\n[world]\n" + world;
    return load_world_config(runtime::TomlDocument::parse(text, "test.toml"));
  }
  /// The message of the refusal; fails the test if there is none.
  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(load());
    } catch (const runtime::StartError& error) {
      return error.what();
    }
    ADD_FAILURE() << "accepted";
    return "";
  }
  [[nodiscard]] Scenario with(const std::string& more) const {
    Scenario changed = *this;
    changed.world += more;
    return changed;
  }
};

TEST(WorldConfig, KeepsDefaultsForKeysThatAreAbsent) {
  const WorldConfig config = Scenario{}.load();
  EXPECT_DOUBLE_EQ(config.step_s, 0.032);
  EXPECT_DOUBLE_EQ(config.start_spacing_m, 0.8);
  EXPECT_EQ(config.robots.count, 15U);
  EXPECT_TRUE(config.boxes.empty());
}

TEST(WorldConfig, ReadsEveryKindOfObstacle) {
  const WorldConfig config =
      Scenario{}
          .with(
              "[[world.box]]\ncentre_m = [0.0, 1.0]\nsize_m = [2.0, 1.0]\nyaw_rad = 0.5\n"
              "[[world.cylinder]]\ncentre_m = [3.0, 0.0]\nradius_m = 0.4\nheight_m = 2.0\n"
              "[[world.outline]]\npoints_m = [[-2, -2], [0, -2], [-1, -1]]\n")
          .load();
  ASSERT_EQ(config.boxes.size(), 1U);
  EXPECT_DOUBLE_EQ(config.boxes[0].yaw_rad, 0.5);
  EXPECT_DOUBLE_EQ(config.boxes[0].height_m, 1.0);
  ASSERT_EQ(config.cylinders.size(), 1U);
  EXPECT_DOUBLE_EQ(config.cylinders[0].height_m, 2.0);
  ASSERT_EQ(config.outlines.size(), 1U);
  EXPECT_EQ(config.outlines[0].points_m.size(), 3U);
}

TEST(WorldConfig, NamesTheLineOfAnUnknownKey) {
  EXPECT_THAT(Scenario{}.with("friction = 1.0\n").refusal(),
              AllOf(StartsWith("test.toml:12: world.friction: "), HasSubstr("unknown key")));
  EXPECT_THAT(Scenario{}.with("[[world.box]]\ncentre_m = [0, 0]\nsize_m = [1, 1]\nyaw_deg = 3\n").refusal(),
              AllOf(StartsWith("test.toml:15: world.box.yaw_deg: "), HasSubstr("unknown key")));
}

TEST(WorldConfig, RefusesAnObstacleWithoutPlaceOrSize) {
  EXPECT_THAT(Scenario{}.with("[[world.box]]\nsize_m = [1, 1]\n").refusal(),
              HasSubstr("world.box.centre_m: is missing"));
  EXPECT_THAT(Scenario{}.with("[[world.cylinder]]\ncentre_m = [1, 1]\n").refusal(),
              HasSubstr("world.cylinder.radius_m: is missing"));
  EXPECT_THAT(Scenario{}.with("[[world.outline]]\nheight_m = 1.0\n").refusal(),
              HasSubstr("world.outline.points_m: is missing"));
}

TEST(WorldConfig, RefusesAMissingStartArea) {
  Scenario scenario;
  scenario.world = "arena_m = [12.0, 12.0]\n";
  EXPECT_THAT(scenario.refusal(), HasSubstr("world.start_low_m: is missing"));
}

TEST(WorldConfig, RefusesObstaclesThatReachOutOfTheArena) {
  EXPECT_THAT(Scenario{}.with("[[world.box]]\ncentre_m = [5.8, 0]\nsize_m = [1, 1]\n").refusal(),
              AllOf(StartsWith("test.toml:13: world.box.centre_m: "), HasSubstr("outside the arena")));
  EXPECT_THAT(Scenario{}.with("[[world.cylinder]]\ncentre_m = [0, 5.7]\nradius_m = 0.4\n").refusal(),
              HasSubstr("outside the arena"));
}

TEST(WorldConfig, RefusesAPolygonThatIsNone) {
  EXPECT_THAT(Scenario{}.with("[[world.outline]]\npoints_m = [[0, 0], [1, 1]]\n").refusal(),
              HasSubstr("needs at least 3 points, has 2"));
  EXPECT_THAT(Scenario{}.with("[[world.outline]]\npoints_m = [[0, 0], [2, 2], [2, 0], [0, 2]]\n").refusal(),
              HasSubstr("crosses or touches itself"));
  EXPECT_THAT(Scenario{}.with("[[world.outline]]\npoints_m = [[0, 0], [0, 0], [2, 0], [0, 2]]\n").refusal(),
              HasSubstr("crosses or touches itself"));
  EXPECT_THAT(
      Scenario{}.with("[[world.outline]]\npoints_m = [[0, 0], [3, 0], [3, 0.1], [0, 0.1]]\n").refusal(),
      HasSubstr("thinner than 0.2 m"));
}

TEST(WorldConfig, RefusesASiteThatNobodyCanReach) {
  Scenario outside;
  outside.robots = "source_m = [-9.0, -4.0]\ndestination_m = [4.0, 4.0]\n";
  EXPECT_THAT(outside.refusal(), AllOf(StartsWith("test.toml:2: robots.source_m: "), HasSubstr("outside")));
  EXPECT_THAT(Scenario{}.with("[[world.box]]\ncentre_m = [4, 4]\nsize_m = [1, 1]\n").refusal(),
              AllOf(HasSubstr("robots.destination_m"), HasSubstr("inside an obstacle")));
}

TEST(WorldConfig, LetsTheDestinationLieAnywhereWhenNothingIsToBeDelivered) {
  Scenario scenario;
  scenario.robots = "source_m = [-4.0, -4.0]\ndestination_m = [400.0, 4.0]\n";
  EXPECT_THAT(scenario.refusal(), HasSubstr("robots.destination_m"));
  scenario.experiment = "items = 0\n";
  EXPECT_DOUBLE_EQ(scenario.load().robots.destination_m[0], 400.0);
}

TEST(WorldConfig, RefusesAStartAreaOutsideTheArenaOrUpsideDown) {
  Scenario outside;
  outside.world = "arena_m = [12.0, 12.0]\nstart_low_m = [-7.0, -5.0]\nstart_high_m = [-3.0, -3.0]\n";
  EXPECT_THAT(outside.refusal(), AllOf(HasSubstr("world.start_low_m"), HasSubstr("outside the arena")));
  Scenario reversed;
  reversed.world = "arena_m = [12.0, 12.0]\nstart_low_m = [-3.0, -3.0]\nstart_high_m = [-5.0, -5.0]\n";
  EXPECT_THAT(reversed.refusal(), HasSubstr("world.start_high_m"));
}

TEST(WorldConfig, RefusesPhysicsStepsThatWouldJumpThroughWalls) {
  EXPECT_THAT(Scenario{}.with("step_s = 0.5\nsubsteps = 1\n").refusal(), HasSubstr("world.substeps"));
}

TEST(WorldConfig, RefusesStartsThatOverlapAndBodiesThatDoNotFitTogether) {
  EXPECT_THAT(Scenario{}.with("start_spacing_m = 0.3\n").refusal(), HasSubstr("world.start_spacing_m"));
  Scenario body;
  body.robots += "body_ahead_m = 0.5\n";
  EXPECT_THAT(body.with("start_spacing_m = 2.0\n").refusal(), HasSubstr("robots.body_ahead_m"));
  body.robots = Scenario{}.robots + "track_m = 0.5\n";
  EXPECT_THAT(body.refusal(), HasSubstr("robots.track_m"));
  body.robots = Scenario{}.robots + "wheel_radius_m = 0.3\n";
  EXPECT_THAT(body.refusal(), HasSubstr("robots.body_height_m"));
}

TEST(WorldConfig, GivesEachRobotAsMuchRoomAsTheArenaIsWrittenFor) {
  Scenario scenario;
  scenario.robots += "count = 36\n";
  const WorldConfig config = scenario.with("arena_for_robots = 9\n").load();
  EXPECT_THAT(config.arena_m, testing::ElementsAre(24.0, 24.0));
  EXPECT_THAT(config.start_low_m, testing::ElementsAre(-10.0, -10.0));
  EXPECT_THAT(config.start_high_m, testing::ElementsAre(-6.0, -6.0));
  EXPECT_THAT(scenario.load().arena_m, testing::ElementsAre(12.0, 12.0));
}

TEST(WorldConfig, RefusesObstaclesInAnArenaThatGrows) {
  const std::string cylinder = "[[world.cylinder]]\ncentre_m = [0.0, 0.0]\nradius_m = 0.4\n";
  EXPECT_THAT(Scenario{}.with("arena_for_robots = 9\n" + cylinder).refusal(),
              HasSubstr("world.arena_for_robots"));
}

TEST(WorldConfig, RefusesTimesThatAreNoNanosecondsAnyMore) {
  Scenario scenario;
  for (const std::string key : {"max_time_s", "start_timeout_s"}) {
    for (const std::string value : {"1e10", "9.3e9", "1e300", "0.0", "-1.0"}) {
      scenario.experiment = key + " = " + value + "\n";
      EXPECT_THAT(scenario.refusal(),
                  StartsWith("test.toml:5: experiment." + key + ": must be above 0 and at most 1e+09, is "));
    }
    scenario.experiment = key + " = 1e9\nitems = 4\n";
    EXPECT_NO_THROW(static_cast<void>(scenario.load()));
  }
}

TEST(WorldConfig, RefusesBodiesThatNoPhysicsCanStep) {
  for (const std::string key : {"wheel_radius_m", "mass_kg", "body_length_m", "body_width_m", "body_height_m",
                                "body_ahead_m", "track_m", "wheel_limit_mps"}) {
    for (const std::string value : {"1e-9", "1e-6", "1e150", "1e300"}) {
      Scenario scenario;
      scenario.robots += key + " = " + value + "\n";
      EXPECT_THAT(scenario.refusal(), StartsWith("test.toml:4: robots." + key + ": must be ")) << value;
    }
  }
}

TEST(WorldConfig, BoundsEveryNumberThatItSquaresOrCountsCellsIn) {
  for (const std::string key : {"service_radius_m", "gps_noise_m", "compass_noise_rad"}) {
    Scenario scenario;
    scenario.robots += key + " = 1e200\n";
    EXPECT_THAT(scenario.refusal(), StartsWith("test.toml:4: robots." + key + ": must be ")) << key;
  }
  for (const std::string key : {"range_m", "noise"}) {
    Scenario scenario;
    scenario.robots += "sonar." + key + " = 1e200\n";
    EXPECT_THAT(scenario.refusal(), HasSubstr("robots.sonar." + key + ": must be ")) << key;
  }
  for (const std::string key : {"wall_height_m", "start_spacing_m"}) {
    EXPECT_THAT(Scenario{}.with(key + " = 1e200\n").refusal(), HasSubstr("world." + key + ": must be "))
        << key;
  }
  for (const std::string obstacle : {"box]]\ncentre_m = [1e200, 0.0]\nsize_m = [1.0, 1.0]",
                                     "box]]\ncentre_m = [0.0, 0.0]\nsize_m = [1e-7, 1.0]",
                                     "box]]\nsize_m = [1.0, 1.0]\ncentre_m = [0.0, 0.0]\nheight_m = 1e200",
                                     "cylinder]]\ncentre_m = [0.0, 0.0]\nradius_m = 1e200",
                                     "outline]]\npoints_m = [[0.0, 0.0], [1e200, 0.0], [0.0, 1e200]]"}) {
    EXPECT_THAT(Scenario{}.with("[[world." + obstacle + "\n").refusal(), HasSubstr("must be ")) << obstacle;
  }
}

TEST(WorldConfig, RefusesMoreObstaclesThanAnybodyWrites) {
  std::string points;
  for (int i = 0; i <= 1000; ++i) points += (i == 0 ? "[" : ", [") + std::to_string(0.001 * i) + ", 0.0]";
  EXPECT_THAT(Scenario{}.with("[[world.outline]]\npoints_m = [" + points + "]\n").refusal(),
              HasSubstr("world.outline.points_m: has 1001 points; at most 1000"));
  std::string boxes;
  for (int i = 0; i <= 10'000; ++i) boxes += "[[world.box]]\ncentre_m = [0.0, 0.0]\nsize_m = [0.01, 0.01]\n";
  EXPECT_THAT(Scenario{}.with(boxes).refusal(), HasSubstr("world.arena_m: holds 10001 obstacles"));
  std::string covers;
  for (int i = 0; i < 41; ++i) covers += "[[world.box]]\ncentre_m = [0.0, 3.0]\nsize_m = [12.0, 6.0]\n";
  EXPECT_THAT(Scenario{}.with(covers).refusal(),
              HasSubstr("world.arena_m: is covered more than 20 times over"));
}

class ShippedScenario : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedScenario, Loads) {
  const std::string file = std::string{CARAVAN_SOURCE_DIR} + "/deploy/scenarios/" + GetParam() + ".toml";
  EXPECT_NO_THROW(static_cast<void>(load_world_config(runtime::TomlDocument::load(file))));
}

INSTANTIATE_TEST_SUITE_P(Deploy, ShippedScenario,
                         ::testing::Values("paper", "paper_code", "small", "scaling", "one_robot"));

}  // namespace
}  // namespace caravan::world
