// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "tests/unit/world/worlds.hpp"
#include "world_server/physics/dynamics.hpp"
#include "world_server/shapes/scene.hpp"

namespace caravan::world {
namespace {

constexpr double kFullSpeed = 1.6;
constexpr double kMayPressIn = 0.06;  // m, at the moment of an impact
constexpr double kMaySettleIn = 0.01;
constexpr double kSharpTip = 0.04;  // m, the tip of an acute corner without a body (see ring_of_boxes)

Point at(const Pose& pose) { return {pose.x_m, pose.y_m}; }

Polygon hull_of(const Pose& pose, double shrunk_by) {
  const double cosine = std::cos(pose.yaw_rad);
  const double sine = std::sin(pose.yaw_rad);
  const Point middle = placed({-0.0425, 0.0}, at(pose), cosine, sine);
  return corners({.centre_m = {middle.x, middle.y},
                  .size_m = {0.485 - 2.0 * shrunk_by, 0.381 - 2.0 * shrunk_by},
                  .yaw_rad = pose.yaw_rad,
                  .height_m = 0.2});
}

/// Whether two convex polygons overlap, by the separating axis theorem.
bool overlap(const Polygon& a, const Polygon& b) {
  for (const Polygon* edges : {&a, &b}) {
    for (std::size_t i = 0; i < edges->size(); ++i) {
      const Point edge = (*edges)[(i + 1) % edges->size()] - (*edges)[i];
      bool apart = true;
      for (const Point corner : edges == &a ? b : a) apart = apart && cross(edge, corner - (*edges)[i]) < 0.0;
      if (apart) return false;
    }
  }
  return true;
}

/// Depth to which the hull is pressed into the solid: how far it must shrink until no corner of either is
/// inside the other.
double pressed_in(const Pose& pose, const Solid& solid) {
  for (double depth = 0.0; depth < 0.19; depth += 0.002) {
    const Polygon hull = hull_of(pose, depth);
    bool clear = true;
    for (const Point corner : hull) clear = clear && !contains(solid, corner);
    for (const Point corner : solid.outline) clear = clear && !contains(hull, corner);
    if (clear) return depth;
  }
  return 0.19;
}

/// The result of driving one robot against a solid for 6 s: the depth that its hull reaches, and the depth at
/// the end.
struct Impact {
  double deepest = 0.0;
  double at_end = 0.0;
  double tilt = 0.0;
  bool touched = false;
};

Impact ram(const WorldConfig& config, const Solid& solid, const Pose& start, double left, double right) {
  Dynamics physics{config, std::array{start}};
  physics.drive(0, left, right);
  Impact impact;
  for (std::uint64_t i = 0; i < steps_in(6.0); ++i) {
    physics.advance();
    impact.at_end = pressed_in(physics.poses()[0], solid);
    impact.deepest = std::max(impact.deepest, impact.at_end);
    impact.tilt = std::max(impact.tilt, physics.stance(0).tilt_rad);
    impact.touched = impact.touched || !physics.touches().empty();
  }
  return impact;
}

/// Rams a solid around the origin from all sides: head-on, oblique, grazing, forwards and backwards.
void ram_from_all_sides(const WorldConfig& config, const Solid& solid, double may_settle_in = kMaySettleIn) {
  int touched = 0;
  for (double side = 0.0; side < 2.0 * std::numbers::pi; side += 0.37) {
    for (const double aside : {0.0, 0.6, 1.0, 1.4}) {
      for (const double direction : {1.0, -1.0}) {
        const Point from{3.5 * std::cos(side) - aside * std::sin(side),
                         3.5 * std::sin(side) + aside * std::cos(side)};
        const double inwards = side + (direction > 0.0 ? std::numbers::pi : 0.0);
        const Impact impact =
            ram(config, solid, {from.x, from.y, inwards}, direction * kFullSpeed, direction * kFullSpeed);
        ASSERT_LT(impact.deepest, kMayPressIn)
            << "side " << side << " aside " << aside << " way " << direction;
        ASSERT_LT(impact.at_end, may_settle_in)
            << "side " << side << " aside " << aside << " way " << direction;
        ASSERT_LT(impact.tilt, 20.0 * kDegree)
            << "side " << side << " aside " << aside << " way " << direction;
        touched += impact.touched ? 1 : 0;
      }
    }
  }
  EXPECT_GT(touched, 60);
}

TEST(Collision, NothingPassesThroughABox) {
  WorldConfig config = empty_world(20.0, 1);
  config.boxes.push_back({.centre_m = {0.0, 0.0}, .size_m = {2.0, 1.4}, .yaw_rad = 0.3, .height_m = 1.0});
  ram_from_all_sides(config, to_solid(config.boxes[0]));
}

TEST(Collision, NothingPassesThroughACylinder) {
  WorldConfig config = empty_world(20.0, 1);
  config.cylinders.push_back({.centre_m = {0.0, 0.0}, .radius_m = 0.8, .height_m = 1.0});
  ram_from_all_sides(config, to_solid(config.cylinders[0]));
}

TEST(Collision, NothingPassesThroughAConcaveOutline) {
  WorldConfig config = empty_world(20.0, 1);
  config.outlines.push_back(
      {.points_m = {{-1.5, -1.2}, {1.4, -1.5}, {1.2, 1.3}, {0.1, -0.2}, {-1.3, 1.4}}, .height_m = 1.0});
  ram_from_all_sides(config, to_solid(config.outlines[0]), kSharpTip);
}

TEST(Collision, NothingPassesThroughTheArenasWalls) {
  const WorldConfig config = empty_world(6.0, 1);
  for (double heading = -3.1; heading < 3.1; heading += 0.23) {
    for (const double way : {kFullSpeed, -kFullSpeed}) {
      Dynamics physics{config, std::array{Pose{0.5, -0.3, heading}}};
      physics.drive(0, way, way);
      for (std::uint64_t i = 0; i < steps_in(8.0); ++i) {
        physics.advance();
        for (const Point corner : hull_of(physics.poses()[0], 0.0)) {
          ASSERT_LT(std::max(std::abs(corner.x), std::abs(corner.y)), 3.0 + kMayPressIn) << heading;
        }
      }
      for (const Point corner : hull_of(physics.poses()[0], kMaySettleIn)) {
        EXPECT_LT(std::max(std::abs(corner.x), std::abs(corner.y)), 3.0) << heading;
      }
    }
  }
}

/// Two robots drive at each other along parallel lines `aside` apart, turned by `skew`.
void ram_each_other(double aside, double skew) {
  const WorldConfig config = empty_world(30.0, 2);
  const std::array starts{Pose{-3.0, 0.0, 0.0}, Pose{3.0, aside, std::numbers::pi + skew}};
  Dynamics physics{config, starts};
  physics.drive(0, kFullSpeed, kFullSpeed);
  physics.drive(1, kFullSpeed, kFullSpeed);
  for (std::uint64_t i = 0; i < steps_in(8.0); ++i) {
    physics.advance();
    const Pose& a = physics.poses()[0];
    const Pose& b = physics.poses()[1];
    ASSERT_FALSE(overlap(hull_of(a, kMayPressIn / 2.0), hull_of(b, kMayPressIn / 2.0)))
        << "aside " << aside << " skew " << skew << " step " << i;
    ASSERT_LT(physics.stance(0).tilt_rad, 20.0 * kDegree) << "aside " << aside << " skew " << skew;
  }
  EXPECT_FALSE(overlap(hull_of(physics.poses()[0], kMaySettleIn), hull_of(physics.poses()[1], kMaySettleIn)));
}

TEST(Collision, RobotsDoNotPassThroughEachOtherHeadOnOrGrazing) {
  for (const double aside : {0.0, 0.1, 0.2, 0.3, 0.36, 0.38}) {
    for (const double skew : {-0.3, -0.05, 0.0, 0.02, 0.2}) ram_each_other(aside, skew);
  }
}

TEST(Collision, ARobotDoesNotPassThroughOneThatStands) {
  const WorldConfig config = empty_world(30.0, 2);
  for (double heading = 0.0; heading < 6.2; heading += 0.31) {
    Dynamics physics{config, std::array{Pose{-2.0, 0.05, 0.0}, Pose{0.0, 0.0, heading}}};
    physics.drive(0, kFullSpeed, kFullSpeed);
    bool touched = false;
    for (std::uint64_t i = 0; i < steps_in(6.0); ++i) {
      physics.advance();
      touched = touched || !physics.touches().empty();
      ASSERT_FALSE(overlap(hull_of(physics.poses()[0], kMayPressIn / 2.0),
                           hull_of(physics.poses()[1], kMayPressIn / 2.0)))
          << heading;
    }
    EXPECT_TRUE(touched) << heading;
  }
}

// All robots drive towards the same point at full speed and keep pushing.
TEST(Collision, NobodyPassesThroughAnybodyInACrowd) {
  constexpr std::uint32_t kCrowd = 12;
  const WorldConfig config = empty_world(12.0, kCrowd);
  std::vector<Pose> starts;
  for (std::uint32_t i = 0; i < kCrowd; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCrowd;
    const double radius = i % 2 == 0 ? 2.0 : 3.5;
    starts.push_back({radius * std::cos(angle), radius * std::sin(angle), wrapped(angle + std::numbers::pi)});
  }
  Dynamics physics{config, starts};
  std::size_t crowded = 0;
  for (std::uint64_t i = 0; i < steps_in(30.0); ++i) {
    for (std::uint32_t k = 0; k < kCrowd; ++k) {
      const Pose& pose = physics.poses()[k];
      const double turn = std::clamp(wrapped(std::atan2(-pose.y_m, -pose.x_m) - pose.yaw_rad), -0.5, 0.5);
      physics.drive(k, kFullSpeed - turn, kFullSpeed + turn);
    }
    physics.advance();
    crowded += physics.touches().size() > kCrowd ? 1U : 0U;
    for (std::uint32_t k = 0; k < kCrowd; ++k) {
      ASSERT_LT(physics.stance(k).tilt_rad, 20.0 * kDegree) << "step " << i << " robot " << k;
      for (std::uint32_t other = 0; other < k; ++other) {
        ASSERT_FALSE(
            overlap(hull_of(physics.poses()[k], kMayPressIn), hull_of(physics.poses()[other], kMayPressIn)))
            << "step " << i << " robots " << k << " and " << other;
      }
    }
  }
  EXPECT_GT(crowded, 300U);
}

TEST(Collision, RobotsThatAreNotSolidPassThroughEachOtherAndNotThroughWalls) {
  WorldConfig config = empty_world(6.0, 2);
  config.robots.solid = false;
  Dynamics physics{config, std::array{Pose{-1.0, 0.0, 0.0}, Pose{1.0, 0.0, 180.0 * kDegree}}};
  physics.drive(0, 0.5, 0.5);
  physics.drive(1, 0.5, 0.5);
  for (std::uint64_t i = 0; i < steps_in(4.0); ++i) {
    physics.advance();
    EXPECT_TRUE(physics.touches().empty());
  }
  EXPECT_NEAR(physics.poses()[0].x_m, 1.0, 0.1);
  EXPECT_NEAR(physics.poses()[1].x_m, -1.0, 0.1);
  EXPECT_NEAR(physics.poses()[0].y_m, 0.0, 0.01);
  for (std::uint64_t i = 0; i < steps_in(6.0); ++i) physics.advance();
  EXPECT_LT(physics.poses()[0].x_m, 3.0);
  EXPECT_GT(physics.poses()[1].x_m, -3.0);
}

TEST(Collision, ReportsWhoTouchesWhatAndNothingElse) {
  const WorldConfig config = empty_world(6.0, 3);
  // Robot 1 drives into robot 3; robot 2 drives into the wall ahead of it.
  Dynamics physics{config, std::array{Pose{-1.0, 0.0, 0.0}, Pose{0.0, 2.0, 0.0}, Pose{0.5, 0.0, 0.0}}};
  physics.advance();
  EXPECT_TRUE(physics.touches().empty());
  physics.drive(0, 0.5, 0.5);
  physics.drive(1, 0.9, 0.9);
  std::vector<Touch> seen;
  for (std::uint64_t i = 0; i < steps_in(4.0); ++i) {
    physics.advance();
    for (const Touch touch : physics.touches()) {
      if (std::find(seen.begin(), seen.end(), touch) == seen.end()) seen.push_back(touch);
    }
  }
  std::sort(seen.begin(), seen.end());
  const std::vector<Touch> expected{{1, 3}, {2, 0}};
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace caravan::world
