// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <span>

#include "tests/unit/world/worlds.hpp"
#include "world_server/physics/dynamics.hpp"
#include "world_server/shapes/point.hpp"

namespace caravan::world {
namespace {

/// One robot on an empty floor, at an arbitrary pose.
class Robot {
 public:
  explicit Robot(double arena_m = 100.0)
      : config_{empty_world(arena_m, 1)}, physics_{config_, std::array{Pose{1.0, -2.0, 0.7}}} {}

  void run(double seconds) {
    for (std::uint64_t i = 0; i < steps_in(seconds); ++i) {
      const double before = pose().yaw_rad;
      physics_.advance();
      turned_ += wrapped(pose().yaw_rad - before);
    }
  }
  [[nodiscard]] Pose pose() const { return physics_.poses()[0]; }
  /// The total angle turned so far, not wrapped.
  [[nodiscard]] double turned() const { return turned_; }
  [[nodiscard]] Dynamics& physics() { return physics_; }

 private:
  WorldConfig config_;
  Dynamics physics_;
  double turned_ = 0.0;
};

double distance(const Pose& a, const Pose& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

constexpr double kTrack = 0.330;
constexpr double kTolerance = 0.02;

class Drive : public ::testing::TestWithParam<double> {};

TEST_P(Drive, GoesStraightAtTheSpeedOfItsRims) {
  const double speed = GetParam();
  Robot robot;
  robot.physics().drive(0, speed, speed);
  robot.run(1.6);  // until it has reached its speed
  const Pose from = robot.pose();
  robot.run(16.0);
  const Pose to = robot.pose();
  EXPECT_NEAR(distance(from, to), 16.0 * speed, kTolerance * 16.0 * speed);
  const double heading = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
  EXPECT_NEAR(wrapped(heading - 0.7), 0.0, 0.001);
  EXPECT_NEAR(wrapped(to.yaw_rad - 0.7), 0.0, 0.001);
  RecordProperty("distance_error", std::to_string(distance(from, to) / (16.0 * speed) - 1.0));
}

TEST_P(Drive, GoesStraightFromRestWithinTheSameTolerance) {
  const double speed = GetParam();
  Robot robot;
  const Pose from = robot.pose();
  robot.physics().drive(0, speed, speed);
  robot.run(16.0);
  EXPECT_NEAR(distance(from, robot.pose()), 16.0 * speed, kTolerance * 16.0 * speed);
  RecordProperty("distance_error", std::to_string(distance(from, robot.pose()) / (16.0 * speed) - 1.0));
}

TEST_P(Drive, TurnsInPlaceAtTwiceTheRimSpeedOverTheTrack) {
  const double speed = GetParam();
  Robot robot;
  robot.physics().drive(0, -speed, speed);
  robot.run(1.6);
  const double before = robot.turned();
  const Pose from = robot.pose();
  robot.run(16.0);
  const double expected = 16.0 * 2.0 * speed / kTrack;
  EXPECT_NEAR(robot.turned() - before, expected, kTolerance * expected);
  EXPECT_LT(distance(from, robot.pose()), 0.01);
  RecordProperty("turn_error", std::to_string((robot.turned() - before) / expected - 1.0));
}

TEST_P(Drive, TurnsBothWaysAlike) {
  const double speed = GetParam();
  Robot left;
  Robot right;
  left.physics().drive(0, -speed, speed);
  right.physics().drive(0, speed, -speed);
  left.run(8.0);
  right.run(8.0);
  EXPECT_NEAR(left.turned(), -right.turned(), 1e-3 * left.turned());
}

// The outer rim has the full speed and the inner one half of it: the base follows a circle with a radius of
// 1.5 tracks.
TEST_P(Drive, FollowsAnArcOfTheRightRadiusAtTheRightRate) {
  const double speed = GetParam();
  const double middle = 0.75 * speed;
  const double rate = 0.5 * speed / kTrack;
  const double radius = middle / rate;
  Robot robot;
  robot.physics().drive(0, 0.5 * speed, speed);
  robot.run(1.6);
  const double before = robot.turned();
  const Pose from = robot.pose();
  const Point centre{from.x_m - radius * std::sin(from.yaw_rad), from.y_m + radius * std::cos(from.yaw_rad)};
  const std::uint64_t steps = steps_in(16.0);
  for (std::uint64_t i = 0; i < steps; ++i) {
    robot.run(0.032);
    const Point spoke = Point{robot.pose().x_m, robot.pose().y_m} - centre;
    ASSERT_NEAR(length(spoke), radius, kTolerance * radius) << "after " << i << " steps";
  }
  EXPECT_NEAR(robot.turned() - before, 16.0 * rate, kTolerance * 16.0 * rate);
  RecordProperty("rate_error", std::to_string((robot.turned() - before) / (16.0 * rate) - 1.0));
}

TEST_P(Drive, CountsItsWheelAngles) {
  const double speed = GetParam();
  Robot robot;
  robot.physics().drive(0, speed, -speed);
  robot.run(16.0);
  const double expected = 16.0 * speed / 0.0975;
  EXPECT_NEAR(robot.physics().left_wheel_rad(0), expected, kTolerance * expected);
  EXPECT_NEAR(robot.physics().right_wheel_rad(0), -expected, kTolerance * expected);
}

INSTANTIATE_TEST_SUITE_P(Speeds, Drive, ::testing::Values(0.3, 1.2));

// Robots elsewhere and their number do not change a single bit of a robot's motion: in the open, in a crowd,
// against a wall.
TEST(Fleet, MovesARobotAsIfItWereAlone) {
  const WorldConfig config = empty_world(20.0, 1);
  const std::array starts{Pose{3.0, -2.0, 0.7}, Pose{-4.0, 4.0, 0.0},  Pose{-3.3, 4.0, 3.0},
                          Pose{-3.6, 4.7, 1.0}, Pose{9.0, -9.0, -0.5}, Pose{-4.0, -4.0, 2.0}};
  Dynamics fleet{config, starts};
  Dynamics open{config, std::span{starts}.subspan(0, 1)};
  Dynamics crowd{config, std::span{starts}.subspan(1, 3)};
  Dynamics corner{config, std::span{starts}.subspan(4, 1)};
  std::size_t touches = 0;
  for (std::uint64_t i = 0; i < steps_in(20.0); ++i) {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const double left = 0.4 + 0.3 * std::sin(static_cast<double>(i) / 17.0 + static_cast<double>(k));
      const double right = 0.5;
      fleet.drive(k, left, right);
      if (k == 0) open.drive(0, left, right);
      if (k >= 1 && k <= 3) crowd.drive(k - 1, left, right);
      if (k == 4) corner.drive(0, left, right);
    }
    for (Dynamics* one : {&fleet, &open, &crowd, &corner}) one->advance();
    touches += fleet.touches().size();
    const auto expect_same = [](const Pose& a, const Pose& b) {
      ASSERT_EQ(a.x_m, b.x_m);
      ASSERT_EQ(a.y_m, b.y_m);
      ASSERT_EQ(a.yaw_rad, b.yaw_rad);
    };
    expect_same(fleet.poses()[0], open.poses()[0]);
    for (std::size_t k = 1; k <= 3; ++k) expect_same(fleet.poses()[k], crowd.poses()[k - 1]);
    expect_same(fleet.poses()[4], corner.poses()[0]);
  }
  EXPECT_GT(touches, 20U);
}

TEST(Standing, DriftsLessThanAMillimetreAndATenthOfADegreeInTenMinutes) {
  Robot robot{10.0};
  const Pose from = robot.pose();
  robot.run(600.0);
  EXPECT_LT(distance(from, robot.pose()), 0.001);
  EXPECT_LT(std::abs(wrapped(robot.pose().yaw_rad - from.yaw_rad)), 0.1 * kDegree);
  RecordProperty("drift_m", std::to_string(distance(from, robot.pose())));
}

TEST(Standing, StaysWhereItStoppedForTenMinutes) {
  Robot robot{10.0};
  robot.physics().drive(0, 0.3, 0.6);
  robot.run(3.0);
  robot.physics().drive(0, 0.0, 0.0);
  robot.run(2.0);
  const Pose from = robot.pose();
  robot.run(600.0);
  EXPECT_LT(distance(from, robot.pose()), 0.001);
  EXPECT_LT(std::abs(wrapped(robot.pose().yaw_rad - from.yaw_rad)), 0.1 * kDegree);
}

TEST(Pushing, NineNewtonsGiveOneMetrePerSecondSquaredWithWheelsFree) {
  for (const double direction : {1.0, -1.0}) {
    Robot robot;
    robot.run(1.0);
    robot.physics().free_wheels(0, true);
    const Pose from = robot.pose();
    const double seconds = static_cast<double>(steps_in(4.0)) * 0.032;
    for (std::uint64_t i = 0; i < steps_in(4.0); ++i) {
      robot.physics().push(0, direction * 9.0);
      robot.physics().advance();
    }
    const double acceleration = 2.0 * distance(from, robot.pose()) / (seconds * seconds);
    EXPECT_NEAR(acceleration, 1.0, 0.02);
    EXPECT_NEAR(wrapped(robot.pose().yaw_rad - from.yaw_rad), 0.0, 0.01);
    RecordProperty("acceleration", std::to_string(acceleration));
  }
}

TEST(Pushing, BrakedWheelsHoldAgainstTheSamePush) {
  Robot robot;
  const Pose from = robot.pose();
  for (std::uint64_t i = 0; i < steps_in(4.0); ++i) {
    robot.physics().push(0, 9.0);
    robot.physics().advance();
  }
  EXPECT_LT(distance(from, robot.pose()), 0.01);
}

TEST(Braking, FromFullSpeedKeepsAllWheelsOnTheFloor) {
  Robot robot;
  robot.physics().drive(0, 1.6, 1.6);
  robot.run(2.0);
  const Pose from = robot.pose();
  robot.physics().drive(0, 0.0, 0.0);
  double tilt = 0.0;
  for (std::uint64_t i = 0; i < steps_in(1.0); ++i) {
    robot.run(0.032);
    tilt = std::max(tilt, robot.physics().stance(0).tilt_rad);
  }
  EXPECT_LT(tilt, 1.0 * kDegree);
  EXPECT_LT(distance(from, robot.pose()), 0.5);
}

}  // namespace
}  // namespace caravan::world
