// SPDX-License-Identifier: Apache-2.0
#include "world_server/sensors/sonar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/pure/random.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/sensors/devices.hpp"

namespace caravan::world {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();
constexpr std::size_t kAheadRight = 4;  // at (0.166, -0.027), looking 10 degrees to the right

/// The ranges of the first of the robots at these poses.
std::array<double, kSonarCount> heard(const WorldConfig& config, const std::vector<Pose>& poses) {
  Sonars sonars{config};
  sonars.place(poses);
  return sonars.ranges(0);
}

/// A pose at the origin from which sonar 4 looks along x.
Pose looking_along_x() { return {0.0, 0.0, 10.0 * kDegree}; }

double face_x() {
  const Point face = placed({0.166, -0.027}, {}, std::cos(10.0 * kDegree), std::sin(10.0 * kDegree));
  return face.x;
}

WorldConfig one_ray_world(double size_m, std::uint32_t robots = 1) {
  WorldConfig config = empty_world(size_m, robots);
  config.robots.sonar.rays = 1;
  return config;
}

TEST(Sonar, MeasuresFromItsFaceAlongItsAxis) {
  const auto ranges = heard(one_ray_world(8.0), {looking_along_x()});
  EXPECT_NEAR(ranges[kAheadRight], 4.0 - face_x(), 1e-12);
}

TEST(Sonar, HearsNothingBeyondItsRange) {
  const double reach = 2.0 * (5.0 + face_x());
  EXPECT_NEAR(heard(one_ray_world(reach - 1e-6), {looking_along_x()})[kAheadRight], 5.0, 1e-5);
  EXPECT_EQ(heard(one_ray_world(reach + 1e-6), {looking_along_x()})[kAheadRight], kNoEcho);
}

TEST(Sonar, LosesARayThatMeetsASurfaceAtTheReflectionAngleOrMore) {
  for (const auto& [aslant, is_heard] :
       {std::pair{22.4, true}, {22.6, false}, {-22.4, true}, {-22.6, false}}) {
    WorldConfig config = one_ray_world(100.0);
    config.boxes.push_back(
        {.centre_m = {3.0, 0.0}, .size_m = {0.4, 6.0}, .yaw_rad = aslant * kDegree, .height_m = 1.0});
    EXPECT_EQ(std::isfinite(heard(config, {looking_along_x()})[kAheadRight]), is_heard) << aslant;
  }
}

TEST(Sonar, SeesNothingBehindASurfaceThatLosesTheRay) {
  WorldConfig config = one_ray_world(8.0);
  config.boxes.push_back({.centre_m = {2.0, 0.0}, .size_m = {0.1, 3.0}, .yaw_rad = 0.7, .height_m = 1.0});
  EXPECT_EQ(heard(config, {looking_along_x()})[kAheadRight], kNoEcho);
}

TEST(Sonar, TakesTheNearestEchoOfItsRays) {
  WorldConfig config = empty_world(100.0, 1);
  // The cylinder is beside the axis, within the cone of 0.2 rad: only the ray at the left edge of the cone
  // meets it.
  config.cylinders.push_back({.centre_m = {3.0, 3.0 * std::tan(0.2)}, .radius_m = 0.2, .height_m = 1.0});
  config.robots.sonar.rays = 3;
  EXPECT_LT(heard(config, {looking_along_x()})[kAheadRight], 3.0);
  config.robots.sonar.rays = 1;
  EXPECT_EQ(heard(config, {looking_along_x()})[kAheadRight], kNoEcho);
}

TEST(Sonar, NeverHearsTheRobotItSitsOnButHearsOthers) {
  WorldConfig config = one_ray_world(100.0, 2);
  const Pose pose = looking_along_x();
  for (const double range : heard(config, {pose, {40.0, 40.0, 0.0}})) EXPECT_EQ(range, kNoEcho);
  const double back = heard(config, {pose, {2.0, 0.0, 0.0}})[kAheadRight];
  EXPECT_NEAR(back, 2.0 - 0.285 - face_x(), 1e-12);
  const double front = heard(config, {pose, {2.0, 0.0, std::numbers::pi}})[kAheadRight];
  EXPECT_NEAR(front, 2.0 - 0.200 - face_x(), 1e-12);
}

TEST(Sonar, HearsNoRobotThatIsNotSolid) {
  WorldConfig config = one_ray_world(8.0, 2);
  config.robots.solid = false;
  const auto alone = heard(one_ray_world(8.0), {looking_along_x()});
  EXPECT_EQ(heard(config, {looking_along_x(), {1.0, 0.0, 0.0}}), alone);
}

TEST(Sonar, HearsARobotThatTouchesIt) {
  WorldConfig config = one_ray_world(100.0, 2);
  config.robots.sonar.rays = 8;
  const auto ranges = heard(config, {{0.0, 0.0, 0.0}, {0.485, 0.0, 0.0}});
  EXPECT_NEAR(ranges[3], 0.034 / std::cos(10.0 * kDegree - 0.2), 0.002);
}

TEST(Sonar, PassesOverWhatIsLower) {
  WorldConfig config = one_ray_world(8.0);
  config.boxes.push_back({.centre_m = {2.0, 0.0}, .size_m = {1.0, 1.0}, .yaw_rad = 0.0, .height_m = 0.2});
  EXPECT_NEAR(heard(config, {looking_along_x()})[kAheadRight], 4.0 - face_x(), 1e-12);
  config.boxes[0].height_m = 0.22;
  EXPECT_NEAR(heard(config, {looking_along_x()})[kAheadRight], 1.5 - face_x(), 1e-12);
}

TEST(Sonar, HearsTheFloorOnlyUnderASteepRay) {
  WorldConfig config = empty_world(100.0, 1);
  for (const double range : heard(config, {looking_along_x()})) EXPECT_EQ(range, kNoEcho);
  config.robots.sonar.aperture_rad = 1.5;
  config.robots.sonar.reflection_rad = 1.2;
  config.robots.sonar.rays = 32;
  for (const double range : heard(config, {looking_along_x()})) {
    EXPECT_NEAR(range, kSonarHeight / std::sin(0.75), 0.01);
  }
}

TEST(Sonar, IsAtZeroInsideSomething) {
  WorldConfig config = one_ray_world(100.0);
  config.boxes.push_back({.centre_m = {0.26, 0.0}, .size_m = {0.4, 4.0}, .yaw_rad = 0.0, .height_m = 1.0});
  EXPECT_EQ(heard(config, {{0.0, 0.0, 0.0}})[3], 0.0);
  EXPECT_EQ(heard(config, {{0.0, 0.0, 0.0}})[10], kNoEcho);
}

TEST(SonarFan, HasTheAxisAndAnEvenRim) {
  runtime::SonarTable sonar;
  for (std::uint32_t rays = 1; rays <= 32; ++rays) {
    sonar.rays = rays;
    const auto fan = sonar_rays(sonar);
    ASSERT_EQ(fan.size(), rays);
    std::size_t on_axis = 0;
    Point sum;
    for (const Ray& ray : fan) {
      EXPECT_NEAR(dot(ray.flat, ray.flat) + ray.up * ray.up, 1.0, 1e-12);
      on_axis += ray.flat.x > 1.0 - 1e-12 ? 1U : 0U;
      sum = sum + Point{ray.flat.y, ray.up};
    }
    EXPECT_EQ(on_axis, rays == 1 || rays > 3 ? 1U : 0U);
    EXPECT_NEAR(length(sum), 0.0, 1e-12);
  }
  sonar.rays = 3;
  EXPECT_NEAR(sonar_rays(sonar)[0].flat.y, std::sin(0.2), 1e-12);
}

TEST(SonarNoise, IsRelativeAndMakesNoEchoOutOfNone) {
  runtime::RobotsTable robots;
  robots.sonar.noise = 0.05;
  Devices devices{robots, 3, 1};
  std::array<double, kSonarCount> ranges{};
  ranges.fill(2.0);
  ranges[5] = kNoEcho;
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kRounds = 20000;
  for (int i = 0; i < kRounds; ++i) {
    const auto noisy = devices.sonar(ranges);
    ASSERT_EQ(noisy[5], kNoEcho);
    ASSERT_GE(noisy[0], 0.0);
    sum += noisy[0] - 2.0;
    squares += (noisy[0] - 2.0) * (noisy[0] - 2.0);
  }
  EXPECT_NEAR(sum / kRounds, 0.0, 0.005);
  EXPECT_NEAR(std::sqrt(squares / kRounds), 0.1, 0.005);
}

TEST(SonarNoise, DiffersBetweenRobotsAndRepeatsForASeed) {
  runtime::RobotsTable robots;
  robots.sonar.noise = 0.05;
  robots.gps_noise_m = 0.1;
  std::array<double, kSonarCount> ranges{};
  ranges.fill(2.0);
  Devices one{robots, 3, 1};
  Devices again{robots, 3, 1};
  Devices two{robots, 3, 2};
  const auto first = one.sonar(ranges);
  EXPECT_EQ(first, again.sonar(ranges));
  EXPECT_NE(first, two.sonar(ranges));
  EXPECT_NE(one.locate({}).x_m, two.locate({}).x_m);
}

TEST(Compass, StaysInItsInterval) {
  runtime::RobotsTable robots;
  robots.compass_noise_rad = 0.3;
  Devices devices{robots, 3, 1};
  for (int i = 0; i < 1000; ++i) {
    const double yaw = devices.locate({0.0, 0.0, std::numbers::pi}).yaw_rad;
    ASSERT_GT(yaw, -std::numbers::pi);
    ASSERT_LE(yaw, std::numbers::pi);
  }
}

}  // namespace
}  // namespace caravan::world
