// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/pure/random.hpp"
#include "world_server/shapes/neighbours.hpp"
#include "world_server/shapes/reach_map.hpp"

namespace caravan::world {
namespace {

TEST(ReachMap, NamesEverythingWithinReachInOrder) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    std::vector<Solid> things;
    std::vector<Extent> extents;
    for (int i = 0; i < 30; ++i) {
      const Point centre{random.uniform(-9.0, 9.0), random.uniform(-14.0, 14.0)};
      things.push_back({.outline = {}, .centre = centre, .radius = random.uniform(0.1, 2.0), .height = 1.0});
      extents.push_back(extent_of(things.back()));
    }
    const double reach = random.uniform(0.0, 4.0);
    const ReachMap map{{20.3, 29.7}, extents, reach};
    for (int i = 0; i < 100; ++i) {
      const Point place{random.uniform(-10.15, 10.15), random.uniform(-14.85, 14.85)};
      const auto near = map.near(place);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (std::uint32_t k = 0; k < things.size(); ++k) {
        if (distance_to(things[k], place) > reach) continue;
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), k)) << k;
      }
    }
  }
}

TEST(ReachMap, StaysSmallInAVastArena) {
  const std::vector<Extent> extents{{{-5.0, -5.0}, {5.0, 5.0}}};
  const ReachMap map{{100000.0, 100000.0}, extents, 5.0};
  EXPECT_EQ(map.near({0.0, 0.0}).size(), 1U);
  EXPECT_EQ(map.near({40000.0, 0.0}).size(), 0U);
}

TEST(Neighbours, AreThosePointsWithinReachInOrder) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) points.push_back({random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)});
    const double reach = random.uniform(0.1, 6.0);
    Neighbours neighbours;
    neighbours.rebuild(points, reach);
    std::vector<std::uint32_t> found;
    for (const Point place : points) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < points.size(); ++k) {
        if (length(points[k] - place) <= reach) expected.push_back(k);
      }
      neighbours.near(place, found);
      EXPECT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace caravan::world
