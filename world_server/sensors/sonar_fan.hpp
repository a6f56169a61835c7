// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "runtime/scenario/shared_tables.hpp"
#include "world_server/shapes/point.hpp"

namespace caravan::world {

inline constexpr double kSonarHeight = 0.2115;  ///< m above the floor

/// A direction in space, of unit length.
struct Ray {
  Point flat;  ///< its horizontal part
  double up = 0.0;
};

/// The rays of one transducer around its axis x (y left, z up). One ray: the axis. Two or three: on the rim
/// of the cone, evenly, the first to the left. More: the axis, then the others on the rim.
[[nodiscard]] std::vector<Ray> sonar_rays(const runtime::SonarTable& sonar);

}  // namespace caravan::world
