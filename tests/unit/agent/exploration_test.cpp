// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/exploration.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using test::look;
using test::Wall;

TEST(Exploration, InTheOpenTheNewLocationLiesOneStepAwayNearTheHeading) {
  const Exploration exploration;
  pure::Random random{7};
  const Perception seen = look({}, {3.0, -2.0}, 1.2);
  bool left = false;
  bool right = false;
  for (int i = 0; i < 200; ++i) {
    const Point location = new_location_to_explore(seen, {}, {}, {}, random);
    EXPECT_NEAR(seen.distance_to(location), exploration.step_m, 1e-9);
    EXPECT_LE(std::abs(seen.bearing_to(location)), exploration.spread_rad + 1e-9);
    left = left || seen.bearing_to(location) > 0.3;
    right = right || seen.bearing_to(location) < -0.3;
  }
  EXPECT_TRUE(left);
  EXPECT_TRUE(right);
}

TEST(Exploration, InFrontOfAWallTheRangeWidensUntilADirectionIsFree) {
  const std::vector<Wall> walls = {{{0.8, -10.0}, {0.8, 10.0}}};
  const Perception seen = look(walls, {0.0, 0.0}, 0.0);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    EXPECT_LT(new_location_to_explore(seen, {}, {}, {}, random).x(), 0.6);
  }
}

TEST(Exploration, WalledInItTakesTheFreestDirectionAndComesToAnEnd) {
  const auto walls = test::rectangle({0.4, 0.0}, 2.0, 1.0);
  const Perception seen = look(walls, {0.0, 0.0}, 0.0);
  pure::Random random{3};
  const Point location = new_location_to_explore(seen, {}, {}, {}, random);
  EXPECT_TRUE(std::isfinite(location.x()) && std::isfinite(location.y()));
}

TEST(Exploration, TheSameSeedGivesTheSameLocations) {
  const Perception seen = look({}, {0.0, 0.0}, 0.0);
  pure::Random one{5};
  pure::Random other{5};
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(new_location_to_explore(seen, {}, {}, {}, one),
              new_location_to_explore(seen, {}, {}, {}, other));
  }
}

}  // namespace
}  // namespace caravan::agent
