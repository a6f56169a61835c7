// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "robot_agent/core/path/intersections.hpp"
#include "robot_agent/core/path/merge.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent {
namespace {

constexpr std::uint64_t kSeeds = 500;
const Point kSource{-21.5, -22.0};
const Point kDestination{15.93, -3.98};

/// A random path. Coarse ones often share vertices, overlap, touch and turn back on themselves.
Path wandering(pure::Random& random, bool coarse) {
  Path path{kSource};
  const int vertices = static_cast<int>(random.uniform(0.0, 60.0));
  for (int count = 0; count < vertices; ++count) {
    Point next;
    if (coarse) {
      next = {std::round(random.uniform(-6.0, 6.0)), std::round(random.uniform(-6.0, 6.0))};
    } else {
      next = on_grid({random.uniform(-22.0, 17.0), random.uniform(-23.0, 5.0)});
    }
    path.push_back(next);
  }
  path.push_back(kDestination);
  return path;
}

/// A path similar to another: vertices of it, shifted a little, left out, repeated or reversed.
Path relative_of(const Path& path, pure::Random& random) {
  Path result{path.front()};
  for (std::size_t index = 1; index + 1 < path.size(); ++index) {
    const double what = random.unit();
    const Point shift{random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04)};
    if (what < 0.2) continue;
    if (what < 0.3) result.push_back(on_grid(path[index] + Point{random.uniform(-2.0, 2.0), 0.5}));
    if (what < 0.4) result.push_back(path[index - 1]);
    result.push_back(what < 0.6 ? on_grid(path[index] + shift) : path[index]);
  }
  if (random.chance(0.3) && result.size() > 4) std::reverse(result.begin() + 1, result.end());
  result.push_back(path.back());
  return result;
}

struct Pair {
  Path a;
  Path b;
};
Pair random_pair(std::uint64_t seed) {
  pure::Random random{seed};
  const bool coarse = random.chance(0.5);
  const Path a = wandering(random, coarse);
  return {a, random.chance(0.4) ? relative_of(a, random) : wandering(random, coarse)};
}

double distance_to(const Path& path, const Point& point) { return project(path, point).distance_m; }

TEST(MergeProperty, IsTheSameWhicheverOfTheTwoMerges) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    ASSERT_EQ(merge(a, b), merge(b, a));
  }
}

TEST(MergeProperty, IsNeverLongerThanTheShorterAndOftenShorter) {
  int improved = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    const double shorter_m = std::min(length_m(a), length_m(b));
    const double merged_m = length_m(merge(a, b));
    ASSERT_LE(merged_m, shorter_m);
    improved += merged_m < shorter_m ? 1 : 0;
  }
  EXPECT_GT(improved, 250);
}

TEST(MergeProperty, StartsAndEndsWhereTheTwoDoAndLiesOnTheGrid) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    const Path merged = merge(a, b);
    ASSERT_GE(merged.size(), 2U);
    EXPECT_EQ(merged.front(), kSource);
    EXPECT_EQ(merged.back(), kDestination);
    for (const Point& point : merged) ASSERT_EQ(point, on_grid(point));
  }
}

TEST(MergeProperty, IsConnectedAlongTheTwo) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    const Path merged = merge(a, b);
    for (std::size_t index = 1; index < merged.size(); ++index) {
      const Point along = merged[index] - merged[index - 1];
      // A segment that begins where the merged path changes from one path to the other is at most kTouch_m
      // away from its path.
      const auto stays_on = [&](const Path& path) {
        for (double fraction = 0.0; fraction <= 1.0; fraction += 0.125) {
          if (distance_to(path, merged[index - 1] + fraction * along) > kTouch_m + 0.001) return false;
        }
        return true;
      };
      ASSERT_TRUE(stays_on(a) || stays_on(b)) << "segment " << index;
    }
  }
}

TEST(MergeProperty, HasVerticesOfTheTwoAndTheirCrossingsOnly) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    for (const Point& point : merge(a, b)) {
      const bool is_old =
          std::find(a.begin(), a.end(), point) != a.end() || std::find(b.begin(), b.end(), point) != b.end();
      ASSERT_TRUE(is_old || (distance_to(a, point) < 0.001 && distance_to(b, point) < 0.001));
    }
  }
}

TEST(MergeProperty, OfTheResultWithEitherPathIsNotLonger) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    const Path once = merge(a, b);
    ASSERT_EQ(merge(once, once), once);
    ASSERT_LE(length_m(merge(once, a)), length_m(once));
    ASSERT_LE(length_m(merge(b, once)), length_m(once));
  }
}

/// A direct implementation of Algorithm 7: among all ordered chains of intersections, the one for which the
/// sum of the shorter sections is least.
double algorithm_7(const Path& a, const Path& b, double& most_it_may_cost) {
  auto meetings = *intersections(a, b, 1000000);
  meetings.push_back({{length_m(a), 0, 0}, {length_m(b), 0, 0}, Point{0.0, 0.0}, 0.0});
  std::vector<double> best;
  for (const Intersection& to : meetings) {
    double least = std::min(to.on_a.arc_m, to.on_b.arc_m);
    for (std::size_t from = 0; from < best.size(); ++from) {
      const double section_a = to.on_a.arc_m - meetings[from].on_a.arc_m;
      const double section_b = to.on_b.arc_m - meetings[from].on_b.arc_m;
      if (section_a >= 0.0 && section_b >= 0.0) {
        least = std::min(least, best[from] + std::min(section_a, section_b));
      }
    }
    best.push_back(least);
    most_it_may_cost += to.cost_m;
  }
  return best.back();
}

TEST(MergeProperty, IsAsShortAsAlgorithm7ReadAloudUpToTheCostOfChanging) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto [a, b] = random_pair(seed);
    double cost = 0.0;
    const double expected = algorithm_7(a, b, cost);
    const double merged_m = length_m(merge(a, b));
    ASSERT_LE(merged_m, expected + cost + 1e-9);
    ASSERT_GE(merged_m, expected - cost - 1e-9);
  }
}

}  // namespace
}  // namespace caravan::agent
