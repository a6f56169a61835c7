// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/routes.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace caravan::experiment {
namespace {

using Path = std::vector<Place>;

Path line_at(double y_m) { return {{0.0, y_m}, {40.0, y_m}}; }

TEST(Resample, KeepsEndsAndLengthAndSpacesEqually) {
  const Path path = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}};

  const Path fine = resample(path, 0.3);

  EXPECT_EQ(fine.front(), path.front());
  EXPECT_EQ(fine.back(), path.back());
  EXPECT_EQ(fine.size(), 25U);  // 7 m in 24 pieces
  EXPECT_NEAR(path_length_m(fine), 7.0, 0.2);
  EXPECT_NEAR(fine[1].x_m, 7.0 / 24.0, 1e-12);
}

TEST(Resample, APathWithoutLengthBecomesOneVertex) {
  EXPECT_THAT(resample(Path{{1.0, 2.0}, {1.0, 2.0}}, 0.25), testing::ElementsAre(Place{1.0, 2.0}));
}

TEST(Frechet, IsBelowALimitJustAboveTheDistanceOfParallelLinesAndNotAtIt) {
  const Path one = resample(line_at(0.0), 0.25);
  const Path other = resample(line_at(2.0), 0.25);

  EXPECT_TRUE(is_frechet_below(one, other, 2.001));
  EXPECT_FALSE(is_frechet_below(one, other, 2.0));
}

TEST(Frechet, TellsADetourFromTheStraightWayThoughItsEndsAreTheSame) {
  const Path straight = resample(line_at(0.0), 0.25);
  const Path detour = resample(Path{{0, 0}, {20, 8}, {40, 0}}, 0.25);

  EXPECT_FALSE(is_frechet_below(straight, detour, 3.0));
  EXPECT_TRUE(is_frechet_below(straight, detour, 8.5));
}

TEST(Frechet, TellsALineWalkedBackAndForthThoughNoPointOfItIsFar) {
  const Path straight = resample(line_at(0.0), 0.25);
  const Path to_and_fro = resample(Path{{0, 0}, {30, 0}, {10, 0}, {40, 0}}, 0.25);

  EXPECT_FALSE(is_frechet_below(straight, to_and_fro, 3.0));
}

TEST(CountRoutes, PathsWithinThreeMetresAreOneRoute) {
  const std::vector<Path> paths = {line_at(0.0), line_at(2.5), line_at(10.0)};

  EXPECT_EQ(count_routes(paths), 2U);
}

TEST(CountRoutes, TheLongestPathsThatMayBeReportedTakeNoLongerThanOthers) {
  Path longest;  // 1e11 m
  for (int i = 0; i < 65535; ++i) longest.push_back({i % 2 == 0 ? -1e6 : 1e6, i % 3 == 0 ? -1e6 : 1e6});
  const std::vector<Path> paths = {longest, longest, line_at(0.0)};

  EXPECT_EQ(count_routes(paths), 2U);
}

TEST(CountRoutes, AChainOfNearPathsIsOneRoute) {
  const std::vector<Path> paths = {line_at(0.0), line_at(5.0), line_at(2.5)};

  EXPECT_EQ(count_routes(paths), 1U);
}

TEST(CountRoutes, ARobotWithoutPathIsNoRoute) {
  EXPECT_EQ(count_routes(std::vector<Path>{{}, {}}), 0U);
  EXPECT_EQ(count_routes(std::vector<Path>{{}, line_at(0.0)}), 1U);
}

}  // namespace
}  // namespace caravan::experiment
