// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numbers>

#include "robot_agent/core/navigation/avoidance.hpp"
#include "robot_agent/core/navigation/driver.hpp"
#include "robot_agent/core/navigation/forward_view.hpp"
#include "robot_agent/core/navigation/steering.hpp"
#include "robot_agent/core/navigation/stuck.hpp"
#include "robot_agent/core/task/arrival.hpp"
#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using test::look;
using test::Wall;

const std::vector<Wall> kAhead = {{{0.9, -0.5}, {0.9, 0.5}}};
const std::vector<Wall> kNearAhead = {{{0.55, -0.5}, {0.55, 0.5}}};

TEST(Steering, DrivesStraightAtCruiseTowardsAGoalAhead) {
  const Driving driving;
  const Wheels wheels = steer_to(0.0, speed_for(5.0, driving), {}, {});
  EXPECT_DOUBLE_EQ(wheels.left_mps, driving.cruise_mps);
  EXPECT_DOUBLE_EQ(wheels.right_mps, driving.cruise_mps);
}

TEST(Steering, TurnsInPlaceTowardsAGoalBehind) {
  const Wheels wheels = steer_to(2.0, 0.975, {}, {});
  EXPECT_LT(wheels.left_mps, 0.0);
  EXPECT_DOUBLE_EQ(wheels.left_mps, -wheels.right_mps);
}

TEST(Steering, NeverExceedsTheWheelLimit) {
  const Wheels wheels = wheels_for(0.975, 2.5, Body{.wheel_limit_mps = 1.0});
  EXPECT_LE(std::abs(wheels.right_mps), 1.0);
  EXPECT_LT(wheels.left_mps, wheels.right_mps);
}

TEST(Steering, IsSlowNearAnObstacle) {
  const Driving driving;
  EXPECT_DOUBLE_EQ(speed_for(0.9, driving), driving.slow_mps);
  EXPECT_DOUBLE_EQ(speed_for(2.0, driving), driving.cruise_mps);
}

TEST(Driver, AnEchoAheadWithAWaitIsARobotAndBothTurnSlightlyLeft) {
  Driver driver{DriverSettings{}};
  pure::Random random{1};
  Perception seen = look(kAhead, {0, 0}, 0.0);
  seen.robot_near = true;
  EXPECT_EQ(driver.drive_to({5, 0}, seen, random).obstruction, Obstruction::kRobot);
  const Motion motion = driver.drive_to({5, 0}, seen, random);
  EXPECT_EQ(motion.activity, Activity::kAvoiding);
  EXPECT_GT(motion.wheels.right_mps, motion.wheels.left_mps);
}

TEST(Driver, TheSameEchoWithoutAWaitIsAnObstacleAtTheShorterDistance) {
  Driver driver{DriverSettings{}};
  pure::Random random{1};
  EXPECT_EQ(driver.drive_to({5, 0}, look(kAhead, {0, 0}, 0.0), random).obstruction, Obstruction::kNone);
  EXPECT_EQ(driver.drive_to({5, 0}, look(kNearAhead, {0, 0}, 0.0), random).obstruction,
            Obstruction::kObstacle);
}

TEST(Driver, ARobotThatDrivesAndDoesNotMoveBacksOff) {
  Driver driver{DriverSettings{}};
  pure::Random random{1};
  bool touched = false;
  bool backwards = false;
  Perception seen = look({}, {0, 0}, 0.0);
  for (int i = 0; i < 60; ++i) {
    seen.now += 32ms;
    const Motion motion = driver.drive_to({5, 0}, seen, random);
    touched = touched || motion.obstruction == Obstruction::kTouch;
    backwards = backwards || (motion.wheels.left_mps < 0.0 && motion.wheels.right_mps < 0.0);
  }
  EXPECT_TRUE(touched);
  EXPECT_TRUE(backwards);
}

TEST(StuckMonitor, AMovingOrATurningOrAStandingRobotIsNotStuck) {
  const Body body;
  for (const Wheels wheels : {Wheels{0.9, 0.9}, Wheels{-0.3, 0.3}, Wheels{}}) {
    StuckMonitor monitor;
    Perception seen = look({}, {0, 0}, 0.0);
    for (int i = 0; i < 300; ++i) {
      EXPECT_FALSE(monitor.update(seen, wheels, {}, body.track_m));
      seen.now += 32ms;
      const double speed = 0.5 * (wheels.left_mps + wheels.right_mps);
      seen.p_WB.x() += 0.032 * speed;
      seen.yaw_WB_rad =
          wrapped(seen.yaw_WB_rad + 0.032 * (wheels.right_mps - wheels.left_mps) / body.track_m);
    }
  }
}

TEST(Avoidance, WithNoRoomOnTheLeftTheRobotLetsTheOtherPass) {
  const std::vector<Wall> walls = {{{-5, 0.5}, {5, 0.5}}, {{0.6, -0.5}, {0.6, 0.5}}};
  const Perception seen = look(walls, {0, 0}, 0.0);
  const Manoeuvre manoeuvre = turn_slightly_left({seen, {}});
  ASSERT_TRUE(std::holds_alternative<Pause>(manoeuvre.front()));
  const Manoeuvre third = turn_slightly_left({.seen = seen, .settings = {}, .attempt = 2});
  EXPECT_FALSE(std::holds_alternative<Pause>(third.front())) << "it does not wait for ever";
}

TEST(ForwardView, AnEchoThatVanishesAtOnceWhileAWaitIsHeardIsBelievedForTwoSeconds) {
  ForwardView view;
  Perception seen = look({}, {0, 0}, 0.0);
  seen.robot_near = true;
  EXPECT_DOUBLE_EQ(view.update(seen, 1.0, {}).free_ahead_m, 1.0);
  seen.now = 500ms;
  seen.p_WB.x() = 0.2;
  EXPECT_NEAR(view.update(seen, 4.0, {}).free_ahead_m, 0.8, 1e-9);
  seen.now = 2100ms;
  EXPECT_DOUBLE_EQ(view.update(seen, 4.0, {}).free_ahead_m, 4.0);
}

TEST(ForwardView, WithoutAWaitWhatVanishesIsGone) {
  ForwardView view;
  Perception seen = look({}, {0, 0}, 0.0);
  (void)view.update(seen, 1.0, {});
  seen.now = 32ms;
  EXPECT_DOUBLE_EQ(view.update(seen, 4.0, {}).free_ahead_m, 4.0);
}

TEST(ForwardView, ARobotThatDrivesAheadDoesNotCloseInAndOneThatStandsDoes) {
  ForwardView ahead;
  ForwardView standing;
  Perception seen = look({}, {0, 0}, 0.0);
  seen.robot_near = true;
  for (int i = 0; i < 40; ++i) {
    seen.now += 32ms;
    const auto follows = ahead.update(seen, 1.1, {});
    const auto meets = standing.update(seen, 2.4 - 0.03 * i, {});
    if (i < 30) continue;
    EXPECT_NEAR(follows.closing_mps, 0.0, 1e-9);
    EXPECT_NEAR(meets.closing_mps, 0.03 / 0.032, 1e-6);
  }
}

TEST(Avoidance, RoundAnObstacleTheFreeDirectionNearestToTheGoalIsTaken) {
  const std::vector<Wall> walls = {{{0.6, -0.2}, {0.6, 0.7}},
                                   {{-1.0, 0.7}, {0.6, 0.7}}};  // free on the right
  const Perception seen = look(walls, {0, 0}, 0.0);
  const Manoeuvre manoeuvre = go_round({seen, {}});
  ASSERT_TRUE(std::holds_alternative<TurnTo>(manoeuvre.front()));
  EXPECT_LT(std::get<TurnTo>(manoeuvre.front()).yaw_WB_rad, 0.0);
}

TEST(Avoidance, FreeingItselfTheRobotTriesBothSides) {
  const Perception seen = look({}, {0, 0}, 0.0);
  const auto turn_of = [&](int attempt) {
    return std::get<TurnTo>(free_itself({seen, {}, 0.6, 0.0, 0.5, attempt})[1]).yaw_WB_rad;
  };
  EXPECT_LT(turn_of(0) * turn_of(1), 0.0);
  EXPECT_GT(std::abs(turn_of(2)), std::abs(turn_of(0)));
}

TEST(Arrival, WithinOneMetreAndInACrowdWithinTheServiceRadius) {
  EXPECT_TRUE(has_arrived(look({}, {0, 0}, 0.0), {0.99, 0}, {}, {}));
  EXPECT_FALSE(has_arrived(look({}, {0, 0}, 0.0), {1.3, 0}, {}, {}));
  Perception crowded = look(kAhead, {0, 0}, 0.0);
  EXPECT_FALSE(has_arrived(crowded, {1.3, 0}, {}, {})) << "an obstacle without WAIT does not count";
  crowded.robot_near = true;
  EXPECT_TRUE(has_arrived(crowded, {1.3, 0}, {}, {}));
  EXPECT_FALSE(has_arrived(crowded, {1.6, 0}, {}, {}));
}

TEST(Driver, ThatCannotBackOffTurns) {
  Driver driver{DriverSettings{}};
  pure::Random random{1};
  bool backed = false;
  bool turned = false;
  for (int step = 0; step < 400; ++step) {  // the robot never moves, whatever is commanded
    Perception seen = test::look({}, {0, 0}, 0.0);
    seen.now = step * std::chrono::milliseconds{32};
    const Wheels wheels = driver.drive_to({3.0, 0.0}, seen, random).wheels;
    backed = backed || (wheels.left_mps < 0.0 && wheels.right_mps < 0.0);
    turned = turned || wheels.left_mps * wheels.right_mps < 0.0;
  }
  EXPECT_TRUE(backed);
  EXPECT_TRUE(turned);
}

}  // namespace
}  // namespace caravan::agent
