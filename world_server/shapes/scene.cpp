// SPDX-License-Identifier: Apache-2.0
#include "world_server/shapes/scene.hpp"

#include <algorithm>
#include <limits>

namespace caravan::world {

Extent extent_of(const Solid& solid) {
  if (solid.outline.empty()) {
    const Point reach{solid.radius, solid.radius};
    return {solid.centre - reach, solid.centre + reach};
  }
  Extent extent{solid.outline.front(), solid.outline.front()};
  for (const Point vertex : solid.outline) {
    extent.low = {std::min(extent.low.x, vertex.x), std::min(extent.low.y, vertex.y)};
    extent.high = {std::max(extent.high.x, vertex.x), std::max(extent.high.y, vertex.y)};
  }
  return extent;
}

bool contains(const Solid& solid, Point point) {
  if (solid.outline.empty()) return length(point - solid.centre) <= solid.radius;
  return contains(solid.outline, point);
}

double distance_to(const Solid& solid, Point point) {
  if (solid.outline.empty()) return std::max(0.0, length(point - solid.centre) - solid.radius);
  if (contains(solid.outline, point)) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solid.outline.size(); ++i) {
    const Point next = solid.outline[(i + 1) % solid.outline.size()];
    nearest = std::min(nearest, distance_to_segment(point, solid.outline[i], next));
  }
  return nearest;
}

std::vector<Box> arena_walls(const std::array<double, 2>& arena_m, double height_m) {
  const double x = 0.5 * (arena_m[0] + kWallThickness);
  const double y = 0.5 * (arena_m[1] + kWallThickness);
  const std::array<double, 2> upright{kWallThickness, arena_m[1] + 2.0 * kWallThickness};
  const std::array<double, 2> level{arena_m[0] + 2.0 * kWallThickness, kWallThickness};
  return {{.centre_m = {x, 0.0}, .size_m = upright, .yaw_rad = 0.0, .height_m = height_m},
          {.centre_m = {-x, 0.0}, .size_m = upright, .yaw_rad = 0.0, .height_m = height_m},
          {.centre_m = {0.0, y}, .size_m = level, .yaw_rad = 0.0, .height_m = height_m},
          {.centre_m = {0.0, -y}, .size_m = level, .yaw_rad = 0.0, .height_m = height_m}};
}

Solid to_solid(const Box& box) {
  return {.outline = corners(box), .centre = {}, .radius = 0.0, .height = box.height_m};
}

Solid to_solid(const Cylinder& cylinder) {
  return {.outline = {},
          .centre = to_point(cylinder.centre_m),
          .radius = cylinder.radius_m,
          .height = cylinder.height_m};
}

Solid to_solid(const Outline& outline) {
  return {.outline = counter_clockwise(outline), .centre = {}, .radius = 0.0, .height = outline.height_m};
}

}  // namespace caravan::world
