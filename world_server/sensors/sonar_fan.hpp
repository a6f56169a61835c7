// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "runtime/scenario/shared_tables.hpp"
#include "world_server/shapes/point.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Where a transducer sits and looks, in the robot's frame B.
struct SonarMount {
  Point place;               ///< m
  double heading_rad = 0.0;  ///< of its axis
};

/// The Pioneer 3-DX's two arrays of eight: 0 .. 7 ahead from left to right, 8 .. 15 behind from right to left
/// (ARIA's p3dx.p).
[[nodiscard]] const std::array<SonarMount, kSonarCount>& sonar_mounts();

inline constexpr double kSonarHeight = 0.2115;  ///< m above the floor

/// A direction in space, of unit length.
struct Ray {
  Point flat;  ///< its part along the floor
  double up = 0.0;
};

/// The rays of one transducer around its axis x (y left, z up). One ray: the axis. Two or three: on the rim
/// of the cone, evenly, the first to the left. More: the axis, then the others on the rim.
[[nodiscard]] std::vector<Ray> sonar_rays(const runtime::SonarTable& sonar);

}  // namespace caravan::world
