// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/pure/random.hpp"
#include "runtime/scenario/shared_tables.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The noise of one robot's sonars, GPS and compass; each device draws from its own stream, seeded by
/// the scenario and the robot.
class Devices {
 public:
  /// @param robot  numbered from 1
  Devices(const runtime::RobotsTable& robots, std::uint64_t seed, std::uint32_t robot);

  /// Relative noise on each range that is an echo; the result is never negative, and noise never adds or
  /// hides an echo.
  [[nodiscard]] std::array<double, kSonarCount> sonar(std::array<double, kSonarCount> ranges_m);
  /// The position of the GPS, with the yaw of the compass.
  [[nodiscard]] Pose locate(const Pose& truth);

 private:
  double sonar_noise_;
  double gps_noise_m_;
  double compass_noise_rad_;
  pure::Random sonar_random_;
  pure::Random gps_random_;
  pure::Random compass_random_;
};

}  // namespace caravan::world
