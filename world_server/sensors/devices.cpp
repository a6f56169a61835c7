// SPDX-License-Identifier: Apache-2.0
#include "world_server/sensors/devices.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/pure/angle.hpp"

namespace caravan::world {
namespace {

enum class Stream : std::uint64_t { kSonar = 1, kGps, kCompass };

pure::Random stream(std::uint64_t seed, std::uint32_t robot, Stream which) {
  return pure::Random{seed, pure::mix_all(robot, static_cast<std::uint64_t>(which))};
}

}  // namespace

Devices::Devices(const runtime::RobotsTable& robots, std::uint64_t seed, std::uint32_t robot)
    : sonar_noise_{robots.sonar.noise},
      gps_noise_m_{robots.gps_noise_m},
      compass_noise_rad_{robots.compass_noise_rad},
      sonar_random_{stream(seed, robot, Stream::kSonar)},
      gps_random_{stream(seed, robot, Stream::kGps)},
      compass_random_{stream(seed, robot, Stream::kCompass)} {}

std::array<double, kSonarCount> Devices::sonar(std::array<double, kSonarCount> ranges_m) {
  if (sonar_noise_ == 0.0) return ranges_m;
  for (double& range : ranges_m) {
    // Drawn for every transducer, so that an additional echo changes no other noise.
    const double factor = std::max(0.0, 1.0 + sonar_noise_ * sonar_random_.normal());
    if (std::isfinite(range)) range *= factor;
  }
  return ranges_m;
}

Pose Devices::locate(const Pose& truth) {
  Pose seen = truth;
  if (gps_noise_m_ > 0.0) {
    seen.x_m += gps_noise_m_ * gps_random_.normal();
    seen.y_m += gps_noise_m_ * gps_random_.normal();
  }
  if (compass_noise_rad_ > 0.0)
    seen.yaw_rad = pure::wrapped(truth.yaw_rad + compass_noise_rad_ * compass_random_.normal());
  return seen;
}

}  // namespace caravan::world
