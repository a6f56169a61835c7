// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "world_server/shapes/polygon.hpp"

namespace caravan::world {

/// A thing on the floor with vertical sides and a flat top: a prism over a polygon, or over a
/// disc if `outline` is empty.
struct Solid {
  Polygon outline;  ///< counter-clockwise
  Point centre;     ///< of the disc
  double radius = 0.0;
  double height = 0.0;
};

struct Extent {
  Point low;
  Point high;
};

[[nodiscard]] Extent extent_of(const Solid& solid);
[[nodiscard]] bool contains(const Solid& solid, Point point);
/// Distance from a point to the solid's side; 0 inside.
[[nodiscard]] double distance_to(const Solid& solid, Point point);

/// Thickness of the boxes around the arena; their inner faces are on its edge.
inline constexpr double kWallThickness = 0.2;

[[nodiscard]] std::vector<Box> arena_walls(const std::array<double, 2>& arena_m, double height_m);

[[nodiscard]] Solid to_solid(const Box& box);
[[nodiscard]] Solid to_solid(const Cylinder& cylinder);
[[nodiscard]] Solid to_solid(const Outline& outline);

}  // namespace caravan::world
