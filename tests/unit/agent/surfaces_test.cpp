// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surfaces.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using test::Wall;

constexpr double kPi = std::numbers::pi;
constexpr Time kStep = 32ms;

/// What a robot perceives at a time and place, among walls and robots that report their position.
Perception look(std::span<const Wall> walls, Time now, const Point& p_WB, double yaw_rad,
                std::vector<Neighbour> robots = {}) {
  Sensors sensors;
  sensors.sonar_range_m = test::sonar_ranges_m(walls, p_WB, yaw_rad);
  sensors.p_WB = p_WB;
  sensors.yaw_WB_rad = yaw_rad;
  const bool near = !robots.empty();
  return perceive(now, sensors, near, std::move(robots), {}, {}, {});
}

/// The surfaces of a robot with the shortest possible memory.
Surfaces short_memory() { return {SurfaceMemory{.duration = 20s}, {}, false}; }

double nearest_m(const std::vector<Point>& places, const Point& to) {
  double nearest = 1e9;
  for (const Point& place : places) nearest = std::min(nearest, (place - to).norm());
  return nearest;
}

/// Drives 1.5 m along a wall 0.3 m to the left, which ends in a corner at x = 1.
Time drive_along(Surfaces& surfaces, std::span<const Wall> walls) {
  Time now{0};
  for (double x = 0.0; x < 1.5; x += 0.03, now += kStep) surfaces.see(look(walls, now, {x, 0.0}, 0.0));
  return now;
}
const std::vector<Wall> kCorner = {{{-1.0, 0.3}, {1.0, 0.3}}, {{1.0, 0.3}, {1.0, 1.5}}};

TEST(Surfaces, RememberTheCornerThatNoSonarSeesAnyMore) {
  Surfaces surfaces = short_memory();
  const Time then = drive_along(surfaces, kCorner);
  const Point corner{1.0, 0.3};
  const Perception now = look(kCorner, then, {1.25, 0.0}, 0.8);
  surfaces.see(now);
  EXPECT_LT(nearest_m(surfaces.near(now.p_WB, then), corner), 0.08);
  for (const Echo& echo : now.still.echoes())
    EXPECT_GT(echo.range_m, 1.0) << "an echo of sonar " << echo.sonar;
}

TEST(Surfaces, ForgetAfterAWhile) {
  Surfaces surfaces = short_memory();
  const Time then = drive_along(surfaces, kCorner);
  surfaces.see(look({}, then + 15s, {1.2, 0.0}, 0.0));
  EXPECT_FALSE(surfaces.near({1.2, 0.0}, then + 15s).empty());
  surfaces.see(look({}, then + 25s, {1.2, 0.0}, 0.0));
  EXPECT_TRUE(surfaces.near({1.2, 0.0}, then + 25s).empty());
}

TEST(Surfaces, RememberForAsLongAsTheyAreToldWhereverTheRobotHasBeen) {
  Surfaces surfaces{SurfaceMemory{.duration = 300s}, {}, true};
  const Time then = drive_along(surfaces, kCorner);
  surfaces.see(look({}, then + 200s, {40.0, 0.0}, 0.0));
  surfaces.see(look({}, then + 290s, {1.25, 0.0}, 0.8));
  EXPECT_LT(nearest_m(surfaces.near({1.25, 0.0}, then + 290s), {1.0, 0.3}), 0.08);
  surfaces.see(look({}, then + 310s, {1.25, 0.0}, 0.8));
  EXPECT_TRUE(surfaces.near({1.25, 0.0}, then + 310s).empty());
}

TEST(Surfaces, HoldNobodyForLongWhoGetsNowhere) {
  Surfaces surfaces{{}, {}, true};
  const Time then = drive_along(surfaces, kCorner);
  const Time back = then + 100s;
  surfaces.see(look({}, then + 50s, {20.0, 0.0}, 0.0));
  Time now = back;
  for (; now < back + 14s; now += 1s) surfaces.see(look({}, now, {1.25, 0.0}, 0.0));
  EXPECT_FALSE(surfaces.near({1.25, 0.0}, now).empty());
  for (; now < back + 17s; now += 1s) surfaces.see(look({}, now, {1.25, 0.0}, 0.0));
  EXPECT_TRUE(surfaces.near({1.25, 0.0}, now).empty()) << "what it remembers may be wrong";
}

TEST(Surfaces, AreRememberedLongWhereTheyWereTouched) {
  Surfaces surfaces{{}, {}, true};
  surfaces.touch_ahead(look({}, 0s, {2.0, 1.0}, 0.5 * kPi), {});
  surfaces.see(look({}, 100s, {20.0, 1.0}, 0.0));
  EXPECT_LT(nearest_m(surfaces.near({2.0, 1.0}, 200s), {2.0, 1.22}), 0.01);
}

TEST(Surfaces, AreHighWhereTheyWereSeenFromCloseBy) {
  Surfaces surfaces{{}, {}, true};
  const std::vector<Wall> wall = {{{1.0, -1.0}, {1.0, 1.0}}};
  surfaces.see(look(wall, 0s, {0.2, 0.0}, 0.0));
  EXPECT_FALSE(surfaces.is_high({1.0, 0.0})) << "something low would look the same from here";
  surfaces.see(look(wall, 10s, {0.5, 0.0}, 0.0));
  EXPECT_TRUE(surfaces.is_high({1.0, 0.0}));
  EXPECT_TRUE(surfaces.is_high({1.2, 0.3})) << "the corner near by as well";
  EXPECT_FALSE(surfaces.is_high({1.0, 0.8}));
  surfaces.see(look({}, 10h, {0.0, 0.0}, 0.0));
  EXPECT_TRUE(surfaces.is_high({1.0, 0.0})) << "for the whole run";
  surfaces.see(look({}, 10h, {0.5, 0.0}, 0.0, {{RobotId{7}, {1.2, 0.0}, 0.0, 0.0, 0.0}}));
  EXPECT_FALSE(surfaces.is_high({1.0, 0.0})) << "it was a robot";
}

TEST(Surfaces, OfAMapAreBounded) {
  SurfaceMap map{{}};
  for (int i = 0; i < 100'000; ++i) map.touch({0.1 * i, 1e300}, 0s);
  EXPECT_LE(map.size(), 20'000U);
}

TEST(Surfaces, ExpectAWallToGoOnWhileASonarFollowsIt) {
  const std::vector<Wall> oblique = {{{-2.0, 0.5}, {2.0, 0.1}}};  // 0.1 m nearer with each metre
  Surfaces surfaces = short_memory();
  Time now{0};
  for (double x = -0.3; x <= 0.0; x += 0.03, now += kStep) surfaces.see(look(oblique, now, {x, 0.0}, 0.0));
  const std::vector<Point> places = surfaces.near({0.0, 0.0}, now);
  const auto farthest = std::ranges::max_element(places, {}, [](const Point& place) { return place.x(); });
  ASSERT_NE(farthest, places.end());
  EXPECT_GT(farthest->x(), 0.25) << "ahead of the sonar at x = 0.07";
  EXPECT_NEAR(farthest->y(), 0.3 - 0.1 * farthest->x(), 0.05);
}

TEST(Surfaces, AreNeitherRobotsThatTellWhereTheyAreNorAnythingBesideSilentOnes) {
  const std::vector<Wall> body = test::rectangle({0.7, 0.0}, 0.485, 0.381, 0.5 * kPi);
  Surfaces surfaces = short_memory();
  surfaces.see(look(body, 0s, {0, 0}, 0.0, {{RobotId{7}, {0.7, 0.04}, 0.5 * kPi, 0.0, 0.0}}));
  EXPECT_TRUE(surfaces.near({0, 0}, 0s).empty()) << "it says that it is there";

  Perception silent = look(body, 0s, {0, 0}, 0.0);
  silent.robot_near = true;
  surfaces.see(silent);
  EXPECT_TRUE(surfaces.near({0, 0}, 0s).empty()) << "it may be the robot that was heard";

  surfaces.see(look(body, 0s, {0, 0}, 0.0));
  EXPECT_FALSE(surfaces.near({0, 0}, 0s).empty()) << "nobody was heard";
  surfaces.see(look({}, 1s, {0, 0}, 0.0, {{RobotId{7}, {0.7, 0.04}, 0.5 * kPi, 0.0, 0.0}}));
  EXPECT_TRUE(surfaces.near({0, 0}, 0s).empty()) << "it was that robot";
}

TEST(Surfaces, RememberWhatWasTouched) {
  Surfaces surfaces = short_memory();
  surfaces.touch_ahead(look({}, 0s, {2.0, 1.0}, 0.5 * kPi), {});
  EXPECT_LT(nearest_m(surfaces.near({2.0, 1.0}, 0s), {2.0, 1.22}), 0.01);
  EXPECT_LT(nearest_m(surfaces.near({2.0, 1.0}, 0s), {2.19, 1.22}), 0.01);
}

}  // namespace
}  // namespace caravan::agent
