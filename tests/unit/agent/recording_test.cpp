// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/recording.hpp"

#include <gmock/gmock.h>

#include "robot_agent/core/angle.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent {
namespace {

using testing::ElementsAre;

TEST(Recording, BeginsWithTheSourceAndThenTheStart) {
  Recording record{{-1, -1}, {}};
  record.visit({0, 0}, 0.0);
  EXPECT_THAT(record.so_far(), ElementsAre(Point{-1, -1}, Point{0, 0}));
}

TEST(Recording, AVertexEveryMetre) {
  Recording record{{0, 0}, {}};
  for (int i = 0; i <= 350; ++i) record.visit({0.01 * i, 0}, 0.0);
  EXPECT_THAT(record.finished_at({3.5, 0}, {4.2, 0}),
              ElementsAre(Point{0, 0}, Point{1, 0}, Point{2, 0}, Point{3, 0}, Point{3.5, 0}, Point{4.2, 0}));
}

TEST(Recording, ASharpTurnIsAVertexSoThatNoCornerIsCut) {
  Recording record{{0, 0}, {}};
  record.visit({0, 0}, 0.0);
  for (int i = 0; i <= 60; ++i) record.visit({0.01 * i, 0}, 0.0);
  for (int i = 0; i <= 60; ++i) record.visit({0.6, 0.01 * i}, 1.5);
  EXPECT_EQ(record.so_far().back(), (Point{0.6, 0.0}));
}

TEST(Recording, VerticesLieOnTheGrid) {
  Recording record{{0.00049, 0}, {}};
  record.visit({1.23456, 2.34567}, 0.0);
  EXPECT_THAT(record.so_far(), ElementsAre(Point{0, 0}, Point{1.235, 2.346}));
}

TEST(WithoutLoops, APathThatDoesNotCrossItselfStaysAsItIs) {
  const Path path = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}};
  EXPECT_EQ(without_loops(path), path);
}

TEST(WithoutLoops, ALoopIsCutAtTheCrossing) {
  const Path path = {{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, -2}};
  EXPECT_THAT(without_loops(path), ElementsAre(Point{0, 0}, Point{2, 0}, Point{2, -2}));
}

TEST(WithoutLoops, LoopsInsideALoopGoWithIt) {
  const Path path = {{0, 0}, {4, 0}, {4, 3}, {6, 3}, {6, 2}, {3, 2}, {2, 3}, {2, -2}, {1, -3}};
  EXPECT_THAT(without_loops(path), ElementsAre(Point{0, 0}, Point{2, 0}, Point{2, -2}, Point{1, -3}));
}

TEST(WithoutLoopsProperty, TheResultKeepsItsEndsIsShorterAndLiesOnTheOldPath) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    Path path = {{0, 0}};
    double heading = 0.0;
    for (int i = 0; i < 120; ++i) {
      heading += random.uniform(-0.9, 0.9);
      path.push_back(on_grid(path.back() + direction(heading)));
    }
    const Path cut = without_loops(path);
    ASSERT_GE(cut.size(), 2U);
    EXPECT_EQ(cut.front(), path.front());
    EXPECT_EQ(cut.back(), path.back());
    EXPECT_LE(length_m(cut), length_m(path) + 0.01);
    for (std::size_t i = 1; i < cut.size(); ++i) {
      EXPECT_LT(project(path, 0.5 * (cut[i] + cut[i - 1])).distance_m, 0.002);
    }
  }
}

}  // namespace
}  // namespace caravan::agent
