// SPDX-License-Identifier: Apache-2.0
#include "world_server/sensors/sonar_fan.hpp"

#include <cmath>
#include <numbers>

namespace caravan::world {
std::vector<Ray> sonar_rays(const runtime::SonarTable& sonar) {
  const double half = 0.5 * sonar.aperture_rad;
  const bool has_axis = sonar.rays == 1 || sonar.rays > 3;
  std::vector<Ray> rays;
  if (has_axis) rays.push_back({{1.0, 0.0}, 0.0});
  const std::uint32_t on_rim = sonar.rays - (has_axis ? 1 : 0);
  for (std::uint32_t i = 0; i < on_rim; ++i) {
    const double around = 2.0 * std::numbers::pi * i / on_rim;
    rays.push_back({{std::cos(half), std::sin(half) * std::cos(around)}, std::sin(half) * std::sin(around)});
  }
  return rays;
}

}  // namespace caravan::world
