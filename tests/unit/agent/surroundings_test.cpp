// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surroundings.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using test::look;
using test::Wall;

constexpr double kPi = std::numbers::pi;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Surroundings, AWallAheadLimitsTheCorridorAheadAndNotTheOneBehind) {
  const std::vector<Wall> walls = {{{2.0, -3.0}, {2.0, 3.0}}};
  const Perception seen = look(walls, {0.0, 0.0}, 0.0);
  EXPECT_NEAR(seen.around.clearance_m({.bearing_rad = 0.0}), 2.0, 0.05);
  EXPECT_TRUE(std::isinf(seen.around.clearance_m({.bearing_rad = kPi})));
}

TEST(Surroundings, BearingsAreOfTheRobotWhateverItsHeading) {
  const std::vector<Wall> walls = {{{-3.0, 2.0}, {3.0, 2.0}}};
  const Perception seen = look(walls, {0.0, 0.0}, -0.5 * kPi);
  EXPECT_NEAR(seen.around.clearance_m({.bearing_rad = kPi}), 2.0, 0.05);
  EXPECT_TRUE(std::isinf(seen.around.clearance_m({.bearing_rad = 0.0})));
}

TEST(Surroundings, AWallBesideTheRobotLeavesTheWayAheadFree) {
  const std::vector<Wall> walls = {{{-5.0, 0.4}, {5.0, 0.4}}};
  const Perception seen = look(walls, {0.0, 0.0}, 0.0);
  EXPECT_TRUE(std::isinf(seen.around.clearance_m({.bearing_rad = 0.0, .half_width_m = 0.25})));
  EXPECT_LT(seen.around.clearance_m({.bearing_rad = 0.5 * kPi, .half_width_m = 0.25}), 0.5);
}

TEST(Surroundings, AnEchoMayComeFromAnywhereInItsCone) {
  Sensors sensors;
  sensors.sonar_range_m.fill(std::numeric_limits<double>::infinity());
  sensors.sonar_range_m[3] = 3.0;  // 10 degrees to the left, cone half angle 11.5 degrees
  const Surroundings around{sensors, {}};
  EXPECT_LT(around.clearance_m({.bearing_rad = 0.0, .half_width_m = 0.25}), 3.3);
}

TEST(Surroundings, UnknownRangesAreNoEchoesAndWithoutAnyTheRobotIsBlind) {
  Sensors sensors;
  sensors.sonar_range_m.fill(kNan);
  EXPECT_TRUE((Surroundings{sensors, {}}.is_blind()));
  sensors.sonar_range_m[9] = 1.0;  // one at the rear
  EXPECT_TRUE((Surroundings{sensors, {}}.is_blind()));
  sensors.sonar_range_m[0] = 1.0;
  const Surroundings around{sensors, {}};
  EXPECT_FALSE(around.is_blind());
  EXPECT_TRUE(std::isinf(around.clearance_m({.bearing_rad = 0.0})));
}

TEST(Surroundings, ARangeOlderThanASecondIsUnknown) {
  Sensors sensors;
  sensors.sonar_range_m.fill(1.0);
  sensors.sonar_age_s.fill(0.3);
  EXPECT_LT((Surroundings{sensors, {}}.clearance_m({.bearing_rad = 0.0})), 1.3);
  sensors.sonar_age_s.fill(1.1);
  EXPECT_TRUE((Surroundings{sensors, {}}.is_blind()));
}

TEST(Surroundings, TheFrontFanHasNoGap) {
  Sensors sensors;
  const Surroundings around{sensors, {}};
  EXPECT_TRUE(around.in_front_fan(0.0));
  EXPECT_TRUE(around.in_front_fan(-60.0 * kPi / 180.0));
  EXPECT_FALSE(around.in_front_fan(70.0 * kPi / 180.0));
  EXPECT_FALSE(around.in_front_fan(kPi));
}

}  // namespace
}  // namespace caravan::agent
