// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/bending.hpp"

#include <gmock/gmock.h>

#include "runtime/pure/random.hpp"

namespace caravan::agent {
namespace {

const Path kStraight = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};

double nearest_m(const Path& path, const Point& place) { return project(path, place).distance_m; }

TEST(Bending, LeadsRoundAPlaceOnTheShorterSideAndKeepsTheRest) {
  const std::vector<Point> places = {{2.5, -0.1}};
  const auto bend = bent_round(kStraight, 0, places, 0.6);
  ASSERT_TRUE(bend);
  EXPECT_GE(nearest_m(bend->path, places[0]), 0.598);
  EXPECT_LT(length_m(bend->path), 5.6);
  EXPECT_EQ(bend->path.front(), kStraight.front());
  EXPECT_EQ(bend->path.back(), kStraight.back());
  EXPECT_EQ(bend->path[bend->first], (Point{1, 0}));
  EXPECT_EQ(bend->path[bend->last], (Point{4, 0}));
  for (const Point& vertex : bend->path) EXPECT_GE(vertex.y(), -1e-9);
}

TEST(Bending, LeavesAPathAloneThatIsClearOrLiesBeforeFrom) {
  EXPECT_FALSE(bent_round(kStraight, 0, std::vector<Point>{{2.5, 0.7}}, 0.6));
  EXPECT_FALSE(bent_round(kStraight, 4, std::vector<Point>{{1.5, 0.1}}, 0.6));
  EXPECT_FALSE(bent_round(kStraight, 0, {}, 0.6));
}

TEST(Bending, LeavesAPathAloneThatEndsAtThePlace) {
  EXPECT_FALSE(bent_round(kStraight, 0, std::vector<Point>{{5.0, 0.2}}, 0.6));
}

TEST(Bending, OfABentPathChangesNothing) {
  const std::vector<Point> places = {{1.5, 0.1}, {1.9, 0.15}, {3.5, -0.2}};
  const auto once = bent_round(kStraight, 0, places, 0.6);
  ASSERT_TRUE(once);
  for (const Point& place : places) EXPECT_GT(nearest_m(once->path, place), 0.54);
  EXPECT_FALSE(bent_round(once->path, 0, places, 0.6));
}

// For any path and places, the ends and everything outside the bend stay as they are.
TEST(Bending, ChangesNothingButTheBend) {
  pure::Random random{7, 7};
  for (int run = 0; run < 2000; ++run) {
    SCOPED_TRACE(run);
    Path path;
    for (int i = 0; i < 12; ++i) path.push_back(on_grid({random.uniform(0, 6), random.uniform(0, 6)}));
    std::vector<Point> places;
    for (int i = 0; i < 4; ++i) places.emplace_back(random.uniform(0, 6), random.uniform(0, 6));
    const auto bend = bent_round(path, 2, places, 0.6);
    if (!bend) continue;
    ASSERT_LT(bend->first, bend->last);
    ASSERT_LT(bend->last, bend->path.size());
    ASSERT_GE(bend->first, 2U);
    const std::size_t behind = bend->path.size() - bend->last;
    for (std::size_t i = 0; i <= bend->first; ++i) ASSERT_EQ(bend->path[i], path[i]);
    for (std::size_t i = 1; i <= behind; ++i) {
      ASSERT_EQ(bend->path[bend->path.size() - i], path[path.size() - i]);
    }
  }
}

}  // namespace
}  // namespace caravan::agent
