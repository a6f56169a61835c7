// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A polyline in frame W from the source ([0]) to the destination (last). Its vertices lie on a grid of 1 mm,
/// the resolution of the radio's path frames, so that a path is the same for the robot that sends it and the
/// one that receives it.
using Path = std::vector<Point>;

/// The nearest point of the 1 mm grid.
[[nodiscard]] Point on_grid(const Point& point);
/// Sum of the lengths of its segments, metres; 0 for fewer than two vertices.
[[nodiscard]] double length_m(std::span<const Point> path);

/// Where a path comes nearest to a point.
struct Projection {
  std::size_t segment = 0;  ///< index of the vertex that the segment begins at
  double fraction = 0.0;    ///< along the segment, [0, 1]
  Point point{0.0, 0.0};
  double distance_m = 0.0;
};
/// @pre at least two vertices
[[nodiscard]] Projection project(std::span<const Point> path, const Point& point);

}  // namespace caravan::agent
