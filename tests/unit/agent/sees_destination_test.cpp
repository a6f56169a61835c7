// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/sees_destination.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using test::look;
using test::Wall;

/// Whether a robot with default settings sees the destination, and where.
std::optional<Point> sees(const Perception& seen, const Point& destination) {
  return sees_destination(seen, Task{.destination = destination}, {}, {});
}

TEST(SeesDestination, WithinFourMetresAndNotBeyond) {
  EXPECT_TRUE(sees(look({}, {0.0, 0.0}, 0.0), {4.0, 0.0}));
  EXPECT_FALSE(sees(look({}, {0.0, 0.0}, 0.0), {4.01, 0.0}));
}

TEST(SeesDestination, ItSaysWhere) {
  EXPECT_EQ(sees(look({}, {1.0, 1.0}, 0.0), {2.0, 3.0}), (Point{2.0, 3.0}));
}

TEST(SeesDestination, AlsoBehindTheRobot) {
  EXPECT_TRUE(sees(look({}, {0.0, 0.0}, std::numbers::pi), {3.0, 0.0}));
}

TEST(SeesDestination, NotThroughAWall) {
  for (const double wall_x : {0.8, 1.5, 2.5}) {
    SCOPED_TRACE(wall_x);
    const std::vector<Wall> walls = {{{wall_x, -4.0}, {wall_x, 4.0}}};
    EXPECT_FALSE(sees(look(walls, {0.0, 0.0}, 0.0), {3.0, 0.0}));
    EXPECT_FALSE(sees(look(walls, {0.0, 0.0}, std::numbers::pi), {3.0, 0.0}));
  }
}

TEST(SeesDestination, AWallBehindTheDestinationDoesNotHideIt) {
  const std::vector<Wall> walls = {{{3.6, -4.0}, {3.6, 4.0}}};
  EXPECT_TRUE(sees(look(walls, {0.0, 0.0}, 0.0), {3.0, 0.0}));
}

}  // namespace
}  // namespace caravan::agent
