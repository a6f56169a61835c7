// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/keep_clear.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/meeting.hpp"
#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using test::Wall;

constexpr double kPi = std::numbers::pi;
constexpr double kCruise_mps = 0.975;
constexpr Wheels kCruise{kCruise_mps, kCruise_mps};
constexpr Wheels kTurnsLeft{-0.4, 0.4};

Perception among(std::vector<Neighbour> robots, std::span<const Wall> walls = {}) {
  Perception seen = test::look(walls, {0, 0}, 0.0);
  seen.robots = std::move(robots);
  return seen;
}

Neighbour standing(const Point& at, double yaw_rad) { return {RobotId{7}, at, yaw_rad, 0.0, 0.0}; }

Wheels kept(const Wheels& wanted, const Twist& now, const Perception& seen) {
  return keep_clear(wanted, now, seen, {}, {}, {}).wheels;
}

/// A robot at the origin, heading along x, with a wall seen at this distance on its left.
Perception beside_a_wall(double left_m) {
  Perception seen = test::look({}, {0, 0}, 0.0);
  for (double x = -0.8; x < 0.8; x += 0.05) seen.surfaces.emplace_back(x, left_m);
  return seen;
}

TEST(BodyDistance, IsThatBetweenTheRectangles) {
  const Body body;
  const Pose here{{0, 0}, 0.0};  // the body reaches from -0.285 to 0.2 along x and 0.1905 to each side
  EXPECT_NEAR(distance_m(here, Pose{{1.0, 0.0}, kPi}, body), 0.6, 1e-9) << "front to front";
  EXPECT_NEAR(distance_m(here, Pose{{0.0, 0.5}, 0.0}, body), 0.119, 1e-9) << "side by side";
  EXPECT_NEAR(distance_m(here, Pose{{1.0, 0.0}, 0.5 * kPi}, body), 0.6095, 1e-9) << "front to side";
  EXPECT_EQ(distance_m(here, Pose{{0.3, 0.1}, 0.7}, body), 0.0) << "overlapping";
  EXPECT_NEAR(distance_m(here, Point{0.5, 0.5905}, body), 0.5, 1e-9);
  EXPECT_NEAR(signed_distance_m(here, Point{0.5, 0.5905}, body), 0.5, 1e-9);
  EXPECT_NEAR(signed_distance_m(here, Point{0.0, 0.1705}, body), -0.02, 1e-9) << "inside";
}

TEST(KeepClear, ChangesNothingWithNobodyNear) {
  EXPECT_EQ(kept(kCruise, {}, among({})), kCruise);
  EXPECT_EQ(kept(kCruise, {}, among({standing({1.9, 0}, 0.0)})), kCruise);
}

TEST(KeepClear, DoesNotDriveOnTowardsARobotThatIsTooNear) {
  for (const double distance_m : {0.42, 0.5, 0.6}) {
    const Wheels allowed = kept(kCruise, {}, among({standing({distance_m, 0}, 0.5 * kPi)}));
    EXPECT_LE(0.5 * (allowed.left_mps + allowed.right_mps), 1e-9) << distance_m;
  }
}

TEST(KeepClear, DoesNotTurnOnTheSpotIntoARobotBeside) {
  const Neighbour beside = standing({0.0, -0.45}, 0.0);
  const Wheels allowed = kept(kTurnsLeft, {}, among({beside}));
  EXPECT_NE(allowed, kTurnsLeft) << "the rear corner on the right would hit it";
  EXPECT_EQ(kept(kTurnsLeft, {}, among({standing({0.0, -0.7}, 0.0)})), kTurnsLeft) << "room to turn";
}

TEST(KeepClear, LeavesARobotThatTouchesIt) {
  const Wheels backwards{-0.29, -0.29};
  EXPECT_EQ(kept(backwards, {}, among({standing({0.41, 0.0}, kPi)})), backwards);
}

TEST(KeepClear, FollowsARobotThatDrivesAhead) {
  Neighbour ahead = standing({0.9, 0.0}, 0.0);
  ahead.speed_mps = 0.6;
  const Wheels allowed = kept({0.6, 0.6}, {0.6, 0.0}, among({ahead}));
  EXPECT_EQ(allowed, (Wheels{0.6, 0.6}));
}

TEST(KeepClear, DoesNotEscapeIntoAWall) {
  const std::vector<Wall> walls = {{{-0.45, -1.0}, {-0.45, 1.0}}};
  Neighbour comes = standing({0.75, 0.0}, kPi);
  comes.speed_mps = 0.6;
  const Wheels allowed = kept(kCruise, {}, among({comes}, walls));
  EXPECT_GE(allowed.left_mps + allowed.right_mps, 0.0);
}

TEST(KeepClear, DoesNotTurnOnTheSpotNextToAWallSeenAMomentAgo) {
  const Wheels turns_right{0.4, -0.4};
  const Allowed near = keep_clear(turns_right, {}, beside_a_wall(0.26), {}, {}, {});
  EXPECT_NE(near.wheels, turns_right) << "the rear corner on the left would hit it";
  EXPECT_TRUE(near.surface_near);
  const Allowed room = keep_clear(turns_right, {}, beside_a_wall(0.4), {}, {}, {});
  EXPECT_EQ(room.wheels, turns_right);
  EXPECT_FALSE(room.surface_near);
}

TEST(KeepClear, DrivesOnAndAwayFromAWallThatItIsTooNearTo) {
  const Wheels allowed = kept(kCruise, {0.975, 0.0}, beside_a_wall(0.21));
  EXPECT_GT(0.5 * (allowed.left_mps + allowed.right_mps), 0.5);
  EXPECT_GE(allowed.left_mps, allowed.right_mps) << "not towards the wall";
}

TEST(KeepClear, DrivesAlongAWallThatItTouches) {
  for (const double left_m : {0.191, 0.18}) {
    SCOPED_TRACE(left_m);
    EXPECT_EQ(kept(kCruise, {0.975, 0.0}, beside_a_wall(left_m)), kCruise);
    EXPECT_EQ(kept({-0.29, -0.29}, {}, beside_a_wall(left_m)), (Wheels{-0.29, -0.29}));
  }
}

TEST(KeepClear, DoesNotDriveIntoACornerThatItRemembers) {
  Perception seen = test::look({}, {0, 0}, 0.0);
  seen.surfaces.emplace_back(0.45, 0.1);
  const Wheels allowed = kept(kCruise, {0.975, 0.0}, seen);
  EXPECT_LT(0.5 * (allowed.left_mps + allowed.right_mps), 0.6);
  seen.surfaces = {{0.45, 0.3}};
  EXPECT_EQ(kept(kCruise, {0.975, 0.0}, seen), kCruise) << "it passes beside it";
}

TEST(KeepClear, BacksOffFromWhatItTouches) {
  Perception seen = test::look({}, {0, 0}, 0.0);
  seen.surfaces.emplace_back(0.19, 0.1);
  const Wheels backwards{-0.29, -0.29};
  EXPECT_EQ(kept(backwards, {}, seen), backwards);
}

TEST(Meeting, BothFindTheSameSideToPassOn) {
  Neighbour comes = standing({1.8, 0.4}, kPi);
  comes.speed_mps = kCruise_mps;
  const auto mine = find_meeting({0.0, kCruise_mps}, among({comes}), {}, {}, 0.05);
  Perception other = among({{RobotId{3}, {0, 0}, 0.0, kCruise_mps, 0.0}});
  other.p_WB = comes.p_WB;
  other.yaw_WB_rad = kPi;
  const auto theirs = find_meeting({0.0, kCruise_mps}, other, {}, {}, 0.05);
  ASSERT_TRUE(mine && theirs);
  EXPECT_NEAR(mine->passes_m, 0.4, 1e-9) << "on my left";
  EXPECT_NEAR(theirs->passes_m, mine->passes_m, 1e-9) << "and I on its left";
}

TEST(Meeting, OneThatDrivesAheadOrPassesWideOrIsBehindIsNotMet) {
  Neighbour ahead = standing({1.0, 0.0}, 0.2);
  ahead.speed_mps = 0.5;
  EXPECT_FALSE(find_meeting({0.0, kCruise_mps}, among({ahead}), {}, {}, 0.05));
  EXPECT_FALSE(find_meeting({0.0, kCruise_mps}, among({standing({1.0, 1.0}, 0.0)}), {}, {}, 0.05));
  EXPECT_FALSE(find_meeting({0.0, kCruise_mps}, among({standing({-1.0, 0.0}, 0.0)}), {}, {}, 0.05));
  EXPECT_TRUE(find_meeting({0.0, kCruise_mps}, among({standing({1.0, 0.3}, 0.0)}), {}, {}, 0.05));
}

TEST(Neighbours, MoveOnAsTheyToldAndAreForgottenWhenTheyFallSilent) {
  Neighbours neighbours{{}, Time{0}};
  Wait wait;
  wait.from = RobotId{7};
  wait.whereabouts = Whereabouts{{1000, 2000}, 0, 500, 0};
  neighbours.hear(wait, 10s);
  wait.from = RobotId{3};
  wait.whereabouts = Whereabouts{{-1000, 0}, 1571, 0, 0};
  neighbours.hear(wait, 10s);
  wait.from = RobotId{5};
  wait.whereabouts.reset();
  neighbours.hear(wait, 10s);
  const auto soon = neighbours.now(10s + 100ms);
  ASSERT_EQ(soon.size(), 2U);
  EXPECT_EQ(soon[0].id, RobotId{3});
  EXPECT_EQ(soon[1].id, RobotId{7});
  EXPECT_NEAR(soon[1].p_WB.x(), 1.05, 1e-9);
  EXPECT_TRUE(neighbours.now(12s).empty());
}

TEST(Neighbours, WhoDoesNotKnowWhereItIsTellsNothing) {
  Sensors sensors;
  EXPECT_TRUE(whereabouts_of(sensors, 0.1, 0.2));
  sensors.p_WB.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(whereabouts_of(sensors, 0.1, 0.2));
  sensors.p_WB.x() = 1e9;
  EXPECT_FALSE(whereabouts_of(sensors, 0.1, 0.2)) << "does not fit the frame";
}

TEST(Perception, AnEchoOfARobotThatToldWhereItIsIsNotAnObstacle) {
  const std::vector<Wall> walls = {{{0.9, -0.2}, {0.9, 0.2}}};
  Sensors sensors;
  sensors.sonar_range_m = test::sonar_ranges_m(walls, {0, 0}, 0.0);
  const Corridor ahead{};
  const Perception alone = perceive(0s, sensors, true, {}, {}, {}, {});
  EXPECT_LT(alone.still.clearance_m(ahead), 1.0);
  const Perception told = perceive(0s, sensors, true, {standing({1.1, 0.0}, kPi)}, {}, {}, {});
  EXPECT_LT(told.around.clearance_m(ahead), 1.0);
  EXPECT_GT(told.still.clearance_m(ahead), 4.0);
}

}  // namespace
}  // namespace caravan::agent
