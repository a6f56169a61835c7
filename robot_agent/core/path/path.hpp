// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A polyline in frame W from the source (first vertex) to the destination (last). Its vertices lie on a 1 mm
/// grid, the resolution of path frames: sender and receiver have the same path.
using Path = std::vector<Point>;

/// The nearest point of the 1 mm grid.
[[nodiscard]] Point on_grid(const Point& point);
/// Length of the polyline, metres; 0 for fewer than two vertices.
[[nodiscard]] double length_m(std::span<const Point> path);

/// The nearest point of a path to a given point.
struct Projection {
  std::size_t segment = 0;  ///< index of the segment's first vertex
  double fraction = 0.0;    ///< along the segment, [0, 1]
  Point point{0.0, 0.0};
  double distance_m = 0.0;
};
/// @pre at least two vertices
[[nodiscard]] Projection project(std::span<const Point> path, const Point& point);

}  // namespace caravan::agent
