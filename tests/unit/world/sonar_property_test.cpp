// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/world/scenes.hpp"

namespace caravan::world {
namespace {

std::array<double, kSonarCount> brute_force(const Scene& scene, std::size_t robot) {
  const auto solids = solids_around(scene, robot);
  const auto& sonar = scene.config.robots.sonar;
  std::array<double, kSonarCount> ranges{};
  ranges.fill(kNoEcho);
  for_each_ray(scene, scene.poses[robot], [&](std::size_t i, Point from, const Ray& ray) {
    for (const Solid& solid : solids) {
      if (solid.height >= kSonarHeight && contains(solid, from)) ranges[i] = 0.0;
    }
    const Meeting meeting = nearest(solids, from, ray);
    const bool echoes = meeting.cosine > std::cos(sonar.reflection_rad) && meeting.distance <= sonar.range_m;
    if (echoes) ranges[i] = std::min(ranges[i], meeting.distance);
  });
  return ranges;
}

TEST(SonarProperty, EqualsEveryRayAgainstEverySurface) {
  std::size_t echoes = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed, true);
    Sonars sonars{scene.config};
    sonars.place(scene.poses);
    for (std::size_t robot = 0; robot < scene.poses.size(); ++robot) {
      const auto ranges = sonars.ranges(robot);
      const auto expected = brute_force(scene, robot);
      for (std::size_t i = 0; i < kSonarCount; ++i) {
        if (std::isinf(expected[i])) {
          ASSERT_EQ(ranges[i], expected[i]) << "robot " << robot << " sonar " << i;
        } else {
          ASSERT_NEAR(ranges[i], expected[i], 1e-9) << "robot " << robot << " sonar " << i;
          echoes += expected[i] > 0.0 ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_GT(echoes, 5000U);
}

}  // namespace
}  // namespace caravan::world
