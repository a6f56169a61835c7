// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/merge.hpp"

#include <gmock/gmock.h>

namespace caravan::agent {
namespace {

using testing::ElementsAre;

/// Merges in both orders and checks that the results are equal.
Path merged(const Path& own, const Path& other) {
  Path result = merge(own, other);
  EXPECT_EQ(result, merge(other, own));
  EXPECT_LE(length_m(result), std::min(length_m(own), length_m(other)));
  return result;
}

TEST(Merge, TakesTheShorterSectionBetweenCrossings) {
  const Path own{{0, 0}, {5, 5}, {10, 0}, {15, -1}, {20, 0}};
  const Path other{{0, 0}, {5, -1}, {10, 0}, {15, 5}, {20, 0}};
  EXPECT_THAT(merged(own, other),
              ElementsAre(Point{0, 0}, Point{5, -1}, Point{10, 0}, Point{15, -1}, Point{20, 0}));
}

TEST(Merge, PutsAVertexWhereSegmentsCross) {
  const Path own{{0, 0}, {0, 4}, {10, -1}, {20, 0}};
  const Path other{{0, 0}, {10, 1}, {20, -5}, {20, 0}};
  EXPECT_THAT(merged(own, other), ElementsAre(Point{0, 0}, Point{6.667, 0.667}, Point{10, -1}, Point{20, 0}));
}

TEST(Merge, OfPathsThatNeverMeetKeepsTheShorter) {
  const Path own{{0, 0}, {5, 5}, {10, 0}};
  const Path other{{0, 0}, {5, -1}, {10, 0}};
  EXPECT_EQ(merged(own, other), other);
}

TEST(Merge, OfAPathWithItselfIsThePath) {
  const Path path{{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}};
  EXPECT_EQ(merged(path, path), path);
}

TEST(Merge, ChangesAtAVertexThatTouchesTheOtherPath) {
  const Path own{{0, 0}, {0, 5}, {5, 0}, {10, -1}, {20, 0}};
  const Path other{{0, 0}, {4.5, 0.03}, {10, 0}, {10, 6}, {20, 0}};
  const Path result = merged(own, other);
  EXPECT_LT(length_m(result), 20.2);
  EXPECT_THAT(result, testing::Contains(Point{10, -1}));
  EXPECT_THAT(result, testing::Contains(Point{4.5, 0.03}));
}

TEST(Merge, DoesNotChangeWhereAVertexIsMoreThanFiveCentimetresAway) {
  const Path own{{0, 0}, {0, 5}, {5, 0.06}, {10, 5}, {20, 0}};
  const Path other{{0, 0}, {5, 0}, {10, 0}, {20, -8}, {20, 0}};
  EXPECT_EQ(merged(own, other), own);
}

TEST(Merge, UsesBothEndsOfAnOverlap) {
  const Path own{{0, 0}, {0, 3}, {5, 0}, {10, 0}, {15, 0}, {20, 0}};
  const Path other{{0, 0}, {5, 0}, {7, 0}, {12, 0}, {15, 0}, {18, 4}, {20, 0}};
  EXPECT_DOUBLE_EQ(length_m(merged(own, other)), 20.0);
}

TEST(Merge, CutsALoopOfOneOutOfBoth) {
  const Path own{{0, 0}, {5, 0}, {5, 3}, {3, 3}, {3, -3}, {10, -3}, {10, 0}};
  const Path other{{0, 0}, {2, -4}, {3, -2}, {10, -2.5}, {14, 0}, {10, 0}};
  const Path result = merged(own, other);
  EXPECT_LT(length_m(result), length_m(other));
  EXPECT_LT(length_m(result), length_m(own));
}

TEST(Merge, SkipsIntersectionsInTheOppositeOrder) {
  // Along `own` the crossings come as 1, 2; along `other` as 2, 1. At most one of them can be used.
  const Path own{{0, 0}, {10, 0}, {20, 0}};
  const Path other{{0, 0}, {0, 2}, {14, 2}, {14, -2}, {6, -2}, {6, 2.5}, {20, 2.5}, {20, 0}};
  EXPECT_EQ(merged(own, other), own);
}

TEST(Merge, WithAReversedDetourStillGains) {
  const Path own{{0, 0}, {0, 6}, {8, 6}, {8, 0}, {20, 0}};
  const Path other{{0, 0}, {8, 0}, {8, 6}, {4, 6}, {4, 9}, {20, 9}, {20, 0}};
  EXPECT_DOUBLE_EQ(length_m(merged(own, other)), 20.0);
}

TEST(Merge, ReturnsTheShorterWholeWhenTheEndsAreNotTheSame) {
  const Path own{{0, 0}, {5, 1}, {10, 0}};
  const Path other{{0, 0.06}, {5, -1}, {6, 1}, {10, 0}};
  EXPECT_EQ(merged(own, other), own);
  EXPECT_EQ(merged(other, {{0, 0}, {5, 1}, {10, 0.2}}), (Path{{0, 0}, {5, 1}, {10, 0.2}}));
}

TEST(Merge, OfAPathAndNoneIsThePath) {
  const Path path{{0, 0}, {1, 1}};
  EXPECT_EQ(merge(path, {}), path);
  EXPECT_EQ(merge({{3, 3}}, path), path);
  EXPECT_TRUE(merge({}, {}).empty());
}

TEST(Merge, BearsRepeatedVerticesAndSegmentsWithoutLength) {
  const Path own{{0, 0}, {0, 0}, {5, 5}, {5, 5}, {10, 0}, {10, 0}};
  const Path other{{0, 0}, {5, 4}, {5, 4}, {10, 0}};
  EXPECT_DOUBLE_EQ(length_m(merged(own, other)), length_m(other));
}

TEST(Merge, DoesNotChangeForLessThanTwoMillimetres) {
  const Path own{{0, 0}, {5, 0.1}, {10, 0}, {15, 0.101}, {20, 0}};
  const Path other{{0, 0}, {5, -0.101}, {10, 0}, {15, -0.1}, {20, 0}};
  const Path result = merged(own, other);
  EXPECT_TRUE(result == own || result == other);
}

}  // namespace
}  // namespace caravan::agent
