// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/following.hpp"

#include <gmock/gmock.h>

namespace caravan::agent {
namespace {

const Path kPath = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {3, 2}};

TEST(Following, AVertexIsLeftBehindWhenItIsReachedOrPassed) {
  EXPECT_EQ(next_location(kPath, 1, {0.5, 0.0}, {}), 1U);
  EXPECT_EQ(next_location(kPath, 1, {0.8, 0.1}, {}), 2U);
  EXPECT_EQ(next_location(kPath, 1, {1.1, 0.6}, {}), 2U);
}

TEST(Following, TheLastVertexIsNeverLeftBehind) { EXPECT_EQ(next_location(kPath, 5, {3.4, 2.0}, {}), 5U); }

TEST(Following, ARobotPushedOffItsPathPicksItUpWhereItIsNearest) {
  EXPECT_EQ(next_location(kPath, 1, {2.9, 0.9}, {}), 3U);
}

TEST(Following, SteersAheadOnTheStraightAndNotRoundASharpCorner) {
  EXPECT_LT((look_ahead_point(kPath, 1, {0.2, 0.0}, {}) - Point{0.8, 0.0}).norm(), 1e-9);
  EXPECT_EQ(look_ahead_point(kPath, 2, {1.6, 0.0}, {}), (Point{2.0, 0.0}));
}

TEST(Following, TheFurtherOffThePathTheFurtherAheadItSteers) {
  const Path straight = {{0, 0}, {10, 0}};
  EXPECT_GT(look_ahead_point(straight, 1, {3.0, 0.5}, {}).x(),
            look_ahead_point(straight, 1, {3.0, 0.0}, {}).x());
}

}  // namespace
}  // namespace caravan::agent
