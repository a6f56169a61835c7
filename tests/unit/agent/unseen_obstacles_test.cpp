// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/unseen_obstacles.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "robot_agent/core/navigation/exploration.hpp"
#include "robot_agent/core/navigation/steering.hpp"
#include "robot_agent/core/path/smoothing.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

constexpr Time kStep = 32ms;

/// A robot that drives east on open floor and is stopped where the test says.
class Driven {
 public:
  explicit Driven(const ObstacleMemory& memory = {}) : obstacles{{.memory = memory}} {}

  Surfaces surfaces{{}, {}, true};
  UnseenObstacles obstacles;
  std::vector<Neighbour> robots;
  bool heard = false;
  double gps_noise_m = 0.0;
  double wall_x_m = std::numeric_limits<double>::infinity();  // x of a wall ahead
  double vanishes_m = 0.0;                                    // nearer than this the wall returns no echo
  double beside_m = std::numeric_limits<double>::infinity();  // distance to something on the robot's left

  /// @return number of new places
  int drive(int steps, bool stopped) {
    int news = 0;
    for (int i = 0; i < steps; ++i) {
      now_ += kStep;
      if (!stopped) p_WB_.x() += 0.029;
      if (!stopped) angle_rad_ += 0.029 / Body{}.wheel_radius_m;
      news += look(kDrives) ? 1 : 0;
    }
    return news;
  }
  std::optional<Point> look(const Wheels& told) {
    Sensors sensors;
    sensors.sonar_range_m.fill(std::numeric_limits<double>::infinity());
    const Point front = p_WB_ + Point{0.166, 0.0};
    for (const std::size_t sonar : {3U, 4U}) {
      const double range = wall_x_m - front.x();
      if (range > vanishes_m) sensors.sonar_range_m[sonar] = range / std::cos(0.175);
    }
    if (std::isfinite(beside_m)) sensors.sonar_range_m[0] = beside_m;
    sensors.p_WB = p_WB_ + Point{random_.uniform(-gps_noise_m, gps_noise_m), 0.0};
    sensors.left_wheel_rad = sensors.right_wheel_rad = angle_rad_;
    seen_ = perceive(now_, sensors, heard || !robots.empty(), robots, {}, {}, {});
    surfaces.see(*seen_);
    return obstacles.feel(sensors, told, surfaces, *seen_);
  }
  void stand_at(const Point& p_WB, Time after = kStep) {
    p_WB_ = p_WB;
    now_ += after;
    (void)look({});
  }
  [[nodiscard]] const Perception& seen() const { return *seen_; }

  static constexpr Wheels kDrives{0.9, 0.9};

 private:
  Time now_{0};
  Point p_WB_{0.0, 0.0};
  double angle_rad_ = 0.0;
  std::optional<Perception> seen_;
  pure::Random random_{1, 1};
};

TEST(UnseenObstacles, AreRememberedAndPlannedRoundForTheWholeRun) {
  Driven robot;
  ASSERT_EQ(robot.drive(20, false), 0);
  EXPECT_EQ(robot.drive(4, true), 1);
  const Point front = robot.seen().p_WB + Point{0.2, 0.0};
  robot.stand_at({-1.5, 0.0}, std::chrono::hours{2});
  const Perception& seen = robot.seen();
  ASSERT_EQ(seen.touched_W.size(), 1U);
  EXPECT_NEAR((seen.touched_W[0] - front).norm(), ObstacleMemory{}.margin_m, 1e-9);
  EXPECT_NEAR(free_ahead_m(seen.around, {}), front.x() + 1.5 - 0.2, 1e-9);
  EXPECT_NEAR(free_ahead_m(seen.still, {}), front.x() + 1.5 - 0.2, 1e-9);
  EXPECT_FALSE(is_reachable(seen, {2.5, 0.0}, {}, {})) << "no shortcut leads through it";
  EXPECT_TRUE(is_reachable(seen, {0.5, 1.8}, {}, {}));
  robot.stand_at(front - Point{0.8, 0.0});
  pure::Random random{1, 1};
  for (int i = 0; i < 200; ++i) {
    const Point next = new_location_to_explore(robot.seen(), {}, {}, {}, random);
    EXPECT_GT(std::abs(robot.seen().bearing_to(next)), 0.3);
  }
  robot.stand_at(front - Point{0.5, 0.0});
  EXPECT_THAT(robot.seen().surfaces, testing::SizeIs(1)) << "keep_clear() keeps from it";
}

TEST(UnseenObstacles, AreNotWhatRobotsAre) {
  Driven told;
  told.drive(20, false);
  told.robots = {{RobotId{2}, told.seen().p_WB + Point{0.5, 0.0}, 0.0, 0.0, 0.0}};
  EXPECT_EQ(told.drive(10, true), 0) << "one is there";
  EXPECT_FALSE(told.seen().touched);
  Driven heard;
  heard.drive(20, false);
  heard.heard = true;
  EXPECT_EQ(heard.drive(10, true), 0) << "one is heard and does not tell where it is";
  Driven corner;
  corner.drive(20, false);
  corner.robots = {{RobotId{2}, corner.seen().p_WB + Point{0.5, 0.45}, 0.0, 0.0, 0.0}};
  EXPECT_EQ(corner.drive(10, true), 0) << "one is at the corner of the front";
  Driven elsewhere;
  elsewhere.drive(20, false);
  elsewhere.robots = {{RobotId{2}, elsewhere.seen().p_WB + Point{0.0, 1.0}, 0.0, 0.0, 0.0}};
  EXPECT_EQ(elsewhere.drive(10, true), 1) << "it is not in the way";
}

// A low obstacle returns an echo from a distance, but none from close by.
TEST(UnseenObstacles, AreNotWhatWasSeenFromCloseByBeforeButWhatWasSeenFromADistance) {
  for (const double distance : {0.3, 0.8}) {
    SCOPED_TRACE(distance);
    Driven robot;
    robot.beside_m = distance;
    robot.stand_at(Point{0.78, 0.0} - Point{0.069, 0.136 + distance});
    robot.beside_m = std::numeric_limits<double>::infinity();
    robot.stand_at({0.0, 0.0});
    ASSERT_EQ(robot.drive(20, false), 0);
    const bool is_low = distance > 0.5;
    EXPECT_EQ(robot.drive(4, true), is_low ? 1 : 0) << "touched at x = 0.78";
    EXPECT_EQ(robot.seen().touched_W.empty(), !is_low);
  }
}

TEST(UnseenObstacles, AreForgottenWhenTheyShowThemselvesFromCloseBy) {
  Driven robot;
  robot.drive(20, false);
  ASSERT_EQ(robot.drive(4, true), 1);
  const Point there = robot.seen().p_WB;
  robot.stand_at(there - Point{0.8, 0.0});
  EXPECT_THAT(robot.seen().touched_W, testing::SizeIs(1));
  robot.beside_m = 0.2;
  robot.stand_at(there + Point{0.1, -0.3});
  EXPECT_THAT(robot.seen().touched_W, testing::IsEmpty()) << "it is as high as the sonars";
}

TEST(UnseenObstacles, AreKnownBeforeTheyAreTouchedByTheEchoThatVanishes) {
  for (const double vanishes : {0.57, 0.85}) {
    SCOPED_TRACE(vanishes);
    Driven robot;
    robot.wall_x_m = 2.5;
    robot.vanishes_m = vanishes;
    EXPECT_EQ(robot.drive(70, false), 1);
    ASSERT_THAT(robot.seen().touched_W, testing::SizeIs(1));
    EXPECT_NEAR(robot.seen().touched_W[0].x() - ObstacleMemory{}.margin_m, 2.5, 0.05);
    EXPECT_LT(free_ahead_m(robot.seen().around, {}), 0.5) << "what drives takes it for an echo";
  }
}

TEST(UnseenObstacles, AreNotMadeByEchoesThatVanishOtherwise) {
  Driven high;
  high.wall_x_m = 2.5;
  EXPECT_EQ(high.drive(70, false), 0) << "as high as the sonars";
  Driven away;
  away.wall_x_m = 4.0;
  away.vanishes_m = 1.6;
  EXPECT_EQ(away.drive(90, false), 0) << "too far away: the floor, or a door that shut";
  Driven robot;
  robot.wall_x_m = 2.5;
  robot.vanishes_m = 0.57;
  robot.heard = true;
  EXPECT_EQ(robot.drive(70, false), 0) << "a robot that does not tell where it is";
  Driven told;
  told.wall_x_m = 2.5;
  told.vanishes_m = 0.57;
  told.robots = {{RobotId{2}, {2.7, 0.0}, 0.0, 0.0, 0.0}};
  EXPECT_EQ(told.drive(70, false), 0) << "a robot that told where it is";
}

TEST(UnseenObstacles, AreNotMadeByNoiseOfTheGps) {
  Driven robot;
  robot.gps_noise_m = 0.2;
  EXPECT_EQ(robot.drive(5000, false), 0);
}

TEST(UnseenObstacles, GoWhenTheRobotStandsOnThem) {
  Driven robot;
  robot.drive(20, false);
  ASSERT_EQ(robot.drive(4, true), 1);
  robot.stand_at(robot.seen().p_WB + Point{0.15, 0.0});
  EXPECT_THAT(robot.seen().touched_W, testing::IsEmpty());
}

TEST(UnseenObstacles, HoldNobodyForLong) {
  Driven robot;
  robot.drive(20, false);
  ASSERT_EQ(robot.drive(4, true), 1);  // an operator held it
  const Point there = robot.seen().p_WB;
  for (Time waited{0}; waited < PatienceSettings{}.timeout - 1s; waited += 1s) robot.stand_at(there, 1s);
  EXPECT_THAT(robot.seen().touched_W, testing::SizeIs(1));
  robot.stand_at(there, 2s);
  robot.stand_at(there, 1s);
  EXPECT_THAT(robot.seen().touched_W, testing::IsEmpty());
}

TEST(UnseenObstacles, AreBoundedAndTheOldestGoes) {
  TouchedPlaces places{ObstacleMemory{.places = 3}};
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(places.add({1.0 * i, 0.0}, {1.0, 0.0}));
  EXPECT_FALSE(places.add({7.0, 0.0}, {1.0, 0.0})) << "known";
  EXPECT_TRUE(places.add({20.0, 0.0}, {1.0, 0.0}));
  EXPECT_THAT(places.at({10.0, 0.0}, 100.0),
              testing::ElementsAre(Point{9.0, 0.0}, Point{7.0, 0.0}, Point{20.0, 0.0}));
}

TEST(UnseenObstacles, AreOffWithoutPlaces) {
  Driven robot{ObstacleMemory{.places = 0}};
  robot.drive(20, false);
  EXPECT_EQ(robot.drive(10, true), 0);
  EXPECT_FALSE(robot.seen().touched);
  EXPECT_FALSE(robot.obstacles.touch_ahead(robot.surfaces, robot.seen()));
}

}  // namespace
}  // namespace caravan::agent
