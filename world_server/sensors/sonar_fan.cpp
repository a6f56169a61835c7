// SPDX-License-Identifier: Apache-2.0
#include "world_server/sensors/sonar_fan.hpp"

#include <cmath>
#include <numbers>

namespace caravan::world {
namespace {

constexpr SonarMount mount(double x_mm, double y_mm, double heading_degrees) {
  return {{x_mm / 1000.0, y_mm / 1000.0}, heading_degrees * std::numbers::pi / 180.0};
}

}  // namespace

const std::array<SonarMount, kSonarCount>& sonar_mounts() {
  static constexpr std::array<SonarMount, kSonarCount> kMounts{
      mount(69, 136, 90),     mount(114, 119, 50),     mount(148, 78, 30),     mount(166, 27, 10),
      mount(166, -27, -10),   mount(148, -78, -30),    mount(114, -119, -50),  mount(69, -136, -90),
      mount(-157, -136, -90), mount(-203, -119, -130), mount(-237, -78, -150), mount(-255, -27, -170),
      mount(-255, 27, 170),   mount(-237, 78, 150),    mount(-203, 119, 130),  mount(-157, 136, 90)};
  return kMounts;
}

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
