// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <caravan/random.hpp>
#include <caravan/types.hpp>

namespace caravan {

/// The robot's outline on the floor, a rectangle, and its wheels.
struct Body {
  double length_m = 0.0;
  double ahead_m = 0.0;  ///< from the axle to the front
  double width_m = 0.0;
  double track_m = 0.0;  ///< between the wheels
  double wheel_radius_m = 0.0;
  double wheel_limit_mps = 0.0;  ///< rim speed; faster commands are clamped
};

/// Where a sonar sits and looks, in frame B.
struct SonarMount {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;  ///< of its axis
};

struct Sonars {
  std::array<SonarMount, kSonarCount> mounts{};
  double aperture_rad = 0.0;  ///< full cone of each
  double range_m = 0.0;
};

/// The limits of the robot's radio.
struct Radio {
  std::uint32_t channel_count = 0;
  std::uint32_t mtu_bytes = 0;
};

/// What a controller is told of its robot before the first step. There is nothing about other robots or the
/// world.
struct Robot {
  std::uint32_t id = 1;    ///< from 1
  std::uint64_t seed = 1;  ///< of the run
  Body body;
  Sonars sonars;
  Radio radio;
  Position source;                ///< where items are picked up
  double service_radius_m = 0.0;  ///< a gripper picks up and delivers within it

  /// A stream of random numbers of this run and robot. Different streams are independent.
  [[nodiscard]] Random random(std::uint64_t stream = 0) const { return Random{seed, mix_all(stream, id)}; }
};

}  // namespace caravan
