// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "runtime/pure/random.hpp"
#include "world_server/shapes/polygon.hpp"
#include "world_server/shapes/scene.hpp"

namespace caravan::world {
namespace {

/// A star-shaped polygon with convex and reflex corners of many angles.
Outline random_star(std::uint64_t seed) {
  pure::Random random{seed};
  Outline outline;
  const auto count = static_cast<int>(random.uniform(4.0, 12.0));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.6)) / count;
    const double radius = random.uniform(1.5, 4.0);
    outline.points_m.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

TEST(RingOfBoxes, LiesInsideTheOutline) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const Outline outline = random_star(seed);
    const Solid solid = to_solid(outline);
    for (const Box& box : ring_of_boxes(outline)) {
      for (const Point corner : corners(box)) EXPECT_LE(distance_to(solid, corner), 1e-6);
    }
  }
}

// Every point of the outline is covered by a box: that of its own edge or, at a tip, that of the neighbouring
// edge.
TEST(RingOfBoxes, CoversTheWholeOutlineButTheLastOfSharpTips) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const Outline outline = random_star(seed);
    const Polygon polygon = counter_clockwise(outline);
    const auto ring = ring_of_boxes(outline);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point next = polygon[(i + 1) % polygon.size()];
      for (double along = 0.0; along <= 1.0; along += 0.01) {
        const Point place = polygon[i] + along * (next - polygon[i]);
        double nearest = 1e9;
        for (const Box& box : ring) nearest = std::min(nearest, distance_to(to_solid(box), place));
        EXPECT_LE(nearest, 0.1) << "on edge " << i << " at " << along;
      }
    }
  }
}

TEST(RingOfBoxes, DoesNotDependOnTheDirectionOfTurning) {
  Outline outline = random_star(7);
  const auto ring = ring_of_boxes(outline);
  std::reverse(outline.points_m.begin(), outline.points_m.end());
  const auto reversed = ring_of_boxes(outline);
  ASSERT_EQ(ring.size(), reversed.size());
  EXPECT_EQ(ring[0].centre_m, reversed[0].centre_m);
}

TEST(Polygon, KnowsInsideFromOutside) {
  const Polygon dented{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_TRUE(contains(dented, {0.5, 2.0}));
  EXPECT_TRUE(contains(dented, {3.5, 2.0}));
  EXPECT_FALSE(contains(dented, {2.0, 2.0}));
  EXPECT_FALSE(contains(dented, {5.0, 1.0}));
  EXPECT_DOUBLE_EQ(signed_area(dented), 10.0);
}

}  // namespace
}  // namespace caravan::world
