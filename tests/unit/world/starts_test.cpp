// SPDX-License-Identifier: Apache-2.0
#include "world_server/starts/starts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "build_paths.hpp"
#include "runtime/config/start_error.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/shapes/scene.hpp"

namespace caravan::world {
namespace {

WorldConfig shipped(const std::string& name) {
  return load_world_config(
      runtime::TomlDocument::load(std::string{CARAVAN_SOURCE_DIR} + "/deploy/scenarios/" + name + ".toml"));
}

void expect_sound(const WorldConfig& config, const std::vector<Pose>& starts) {
  const double body = body_radius_m(config.robots);
  ASSERT_EQ(starts.size(), config.robots.count);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Point place{starts[i].x_m, starts[i].y_m};
    EXPECT_LE(std::abs(place.x), 0.5 * config.arena_m[0] - body);
    EXPECT_LE(std::abs(place.y), 0.5 * config.arena_m[1] - body);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(length(place - Point{starts[k].x_m, starts[k].y_m}), config.start_spacing_m);
    }
    for (const Box& box : config.boxes) EXPECT_GT(distance_to(to_solid(box), place), body);
    for (const Cylinder& one : config.cylinders) EXPECT_GT(distance_to(to_solid(one), place), body);
    for (const Outline& one : config.outlines) EXPECT_GT(distance_to(to_solid(one), place), body);
  }
}

TEST(Starts, LieApartAndFreeInTheStartArea) {
  for (const char* name : {"paper", "small", "scaling"}) {
    WorldConfig config = shipped(name);
    for (config.seed = 1; config.seed <= 50; ++config.seed) {
      SCOPED_TRACE(std::string{name} + " seed " + std::to_string(config.seed));
      const auto starts = choose_starts(config);
      expect_sound(config, starts);
      for (const Pose& start : starts) {
        EXPECT_GE(start.x_m, config.start_low_m[0]);
        EXPECT_LE(start.x_m, config.start_high_m[0]);
        EXPECT_GE(start.y_m, config.start_low_m[1]);
        EXPECT_LE(start.y_m, config.start_high_m[1]);
      }
    }
  }
}

TEST(Starts, DependOnTheSeedAlone) {
  WorldConfig config = shipped("paper");
  const auto first = choose_starts(config);
  EXPECT_EQ(first[7].x_m, choose_starts(config)[7].x_m);
  config.seed = 2;
  EXPECT_NE(first[7].x_m, choose_starts(config)[7].x_m);
}

TEST(Starts, GrowIntoFreeGroundWhenTheAreaIsFull) {
  WorldConfig config = shipped("paper");
  config.robots.count = 200;
  const auto starts = choose_starts(config);
  expect_sound(config, starts);
  EXPECT_GT(starts.back().x_m + starts.back().y_m, -60.0);
}

TEST(Starts, FailOnlyWhenTheArenaIsFull) {
  WorldConfig config = empty_world(4.0, 1);
  std::uint32_t most = 0;
  for (config.robots.count = 1; config.robots.count < 100; ++config.robots.count) {
    try {
      expect_sound(config, choose_starts(config));
      most = config.robots.count;
    } catch (const runtime::StartError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("the arena is full"));
      break;
    }
  }
  // Discs of 0.4 m whose centres lie in 3.2 x 3.2 m: a random packing into which no further one fits covers
  // about half of the area.
  EXPECT_GE(most, 12U);
  EXPECT_LE(most, 25U);
}

TEST(Starts, StayOutOfTheHollowOfAnOutline) {
  WorldConfig config = empty_world(12.0, 6);
  config.outlines.push_back({.points_m = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, .height_m = 1.0});
  for (config.seed = 1; config.seed <= 20; ++config.seed) expect_sound(config, choose_starts(config));
}

}  // namespace
}  // namespace caravan::world
