// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>

#include "tests/system/support/grid.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

/// 4 x 3 x 30 runs of the small scenario.
TEST(LargeGrid, SurvivesTenKillsWithoutLosingOrRepeatingARun) {
  test::expect_to_survive_kills(
      {"caravan", "sweep", test::scenario("small.toml"), "--set", "algorithm.vision_radius_m=2,4,6,8",
       "--set", "robots.count=3,4,5", "--seeds", "1-30", "--max-time", "600"},
      10, 2);
}

}  // namespace
}  // namespace caravan
