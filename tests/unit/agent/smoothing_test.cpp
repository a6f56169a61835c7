// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/smoothing.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using test::look;
using test::Wall;

constexpr double kPi = std::numbers::pi;
const Refusals kNone{1.0, 0.45};

/// A path in the order of travel, and the remaining length at each vertex.
struct Way {
  explicit Way(Path vertices) : plan{std::move(vertices)}, to_end_m(plan.size(), 0.0) {
    for (std::size_t i = plan.size() - 1; i > 0; --i) {
      to_end_m[i - 1] = to_end_m[i] + (plan[i] - plan[i - 1]).norm();
    }
  }
  [[nodiscard]] Ahead from(std::size_t next) const { return {plan, to_end_m, next}; }
  Path plan;
  std::vector<double> to_end_m;
};

/// Out to the side and back: from (0, 0) over (2, 3) to (4, 0) and on.
Way detour() { return Way{{{0, 0}, {1, 2}, {2, 3}, {3, 2}, {4, 0}, {5, 0}, {6.5, 0}, {20, 0}}}; }

TEST(Smoothing, TakesTheCandidateThatShortensTheWayMost) {
  const auto shortcut = find_shortcut(detour().from(1), look({}, {0, 0}, 0.0), {}, kNone);
  ASSERT_TRUE(shortcut);
  EXPECT_EQ(shortcut->candidate, 4U);  // (5, 0) saves as much but not more; (6.5, 0) is out of sight
  EXPECT_NEAR(shortcut->gain_m, 2 * std::sqrt(5.0) + 2 * std::sqrt(2.0) - 4.0, 1e-9);
}

TEST(Smoothing, OnAStraightPathThereIsNothingToGain) {
  const Way way{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}};
  EXPECT_FALSE(find_shortcut(way.from(1), look({}, {0.2, 0}, 0.0), {}, kNone));
}

TEST(Smoothing, LooksOnlyAtWhatLiesAheadInTheDirectionOfTravel) {
  Path back = detour().plan;
  std::reverse(back.begin(), back.end());
  const Way way{back};
  // On its way back, at (4, 0), the robot faces the old detour; the shortcut leads to the source.
  const auto shortcut = find_shortcut(way.from(4), look({}, {4, 0}, kPi), {}, kNone);
  ASSERT_TRUE(shortcut);
  EXPECT_EQ(way.plan[shortcut->candidate], (Point{0, 0}));
}

TEST(Smoothing, ACandidateOutsideTheFrontFanIsNotReachable) {
  EXPECT_TRUE(is_reachable(look({}, {0, 0}, 0.0), {3, 0}, {}, {}));
  EXPECT_FALSE(is_reachable(look({}, {0, 0}, kPi), {3, 0}, {}, {}));
  EXPECT_FALSE(is_reachable(look({}, {0, 0}, 0.5 * kPi), {3, 0}, {}, {}));
}

TEST(Smoothing, AWallAcrossTheWayBlocksAndOneBehindTheCandidateDoesNot) {
  const std::vector<Wall> across = {{{2.0, -2.0}, {2.0, 2.0}}};
  EXPECT_FALSE(is_reachable(look(across, {0, 0}, 0.0), {3, 0}, {}, {}));
  EXPECT_TRUE(is_reachable(look(across, {0, 0}, 0.0), {1.4, 0}, {}, {}));
}

TEST(Smoothing, AnObliqueWallAtThirtyDegreesToTheWayBlocks) {
  // The normal of the wall is at 60 degrees to the way, so the sonars that look along the way see no wall.
  for (const double crosses_at : {1.0, 1.5, 2.0}) {
    SCOPED_TRACE(crosses_at);
    const Point along = {std::cos(kPi / 6), std::sin(kPi / 6)};
    const Point middle{crosses_at, 0.0};
    const std::vector<Wall> walls = {{middle - 6.0 * along, middle + 6.0 * along}};
    EXPECT_FALSE(is_reachable(look(walls, {0, 0}, 0.0), {4, 0}, {}, {}));
  }
}

TEST(Smoothing, AWallWhoseNormalIsThirtyDegreesOffTheWayBlocks) {
  for (const double crosses_at : {1.0, 2.0, 3.0}) {
    SCOPED_TRACE(crosses_at);
    const Point along = {std::cos(kPi / 3), std::sin(kPi / 3)};
    const Point middle{crosses_at, 0.0};
    const std::vector<Wall> walls = {{middle - 6.0 * along, middle + 6.0 * along}};
    EXPECT_FALSE(is_reachable(look(walls, {0, 0}, 0.0), {4, 0}, {}, {}));
  }
}

TEST(Smoothing, AWayAlongsideAWallIsReachable) {
  const std::vector<Wall> walls = {{{-10.0, 0.6}, {10.0, 0.6}}};
  EXPECT_TRUE(is_reachable(look(walls, {0, 0}, 0.0), {5, 0}, {}, {}));
}

TEST(Smoothing, WhatWasRefusedIsNotOfferedAgainUntilItsTime) {
  Refusals refusals{1.0, 0.45};
  refusals.refuse({0.3, 0.2}, {4.2, -0.3}, 10s);
  Perception seen = look({}, {0, 0}, 0.0);
  const auto other = find_shortcut(detour().from(1), seen, {}, refusals);
  ASSERT_TRUE(other);
  EXPECT_NE(other->candidate, 4U);
  seen.now = 10s;
  EXPECT_EQ(find_shortcut(detour().from(1), seen, {}, refusals)->candidate, 4U);
}

TEST(Smoothing, TheRefusedPairIsRefusedFromItsOtherEndToo) {
  Refusals refusals{1.0, 0.45};
  refusals.refuse({0, 0}, {5, 0}, 10s);
  EXPECT_TRUE(refusals.refuses({5, 0}, {0, 0}, 1s));
  EXPECT_FALSE(refusals.refuses({5, 3}, {0, 3}, 1s));
}

TEST(Smoothing, AShortcutPastAPlaceOfTouchIsRefused) {
  Refusals refusals{1.0, 0.45};
  refusals.touched({2, 0.3}, 10s);
  EXPECT_TRUE(refusals.refuses({0, 0}, {4, 0}, 1s));
  EXPECT_FALSE(refusals.refuses({0, -1}, {4, -1}, 1s));
  refusals.forget(10s);
  EXPECT_FALSE(refusals.refuses({0, 0}, {4, 0}, 1s));
}

TEST(Smoothing, TheNewVerticesLieOnTheStraightLineAtTheSpacing) {
  const auto [path, next, last] = with_shortcut(detour().from(2), {1, 1.5}, 5, 1.0, 0.3);
  EXPECT_EQ(path.front(), (Point{0, 0}));
  EXPECT_EQ(path.back(), (Point{20, 0}));
  EXPECT_EQ(path[last], (Point{5, 0}));
  EXPECT_EQ(path[next - 1], (Point{1, 1.5}));
  for (std::size_t i = next; i <= last; ++i) {
    EXPECT_NEAR((path[i] - path[i - 1]).norm(), 1.0, 0.15);
    EXPECT_EQ(path[i], on_grid(path[i]));
    const std::vector<Point> line = {{1, 1.5}, {5, 0}};
    EXPECT_LT(project(line, path[i]).distance_m, 0.001);
  }
}

}  // namespace
}  // namespace caravan::agent
