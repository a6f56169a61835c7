// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "world_server/shapes/point.hpp"
#include "world_server/shapes/solids.hpp"

namespace caravan::world {

/// Vertices in order; the last is joined to the first.
using Polygon = std::vector<Point>;

/// Positive for counter-clockwise vertices.
[[nodiscard]] double signed_area(std::span<const Point> polygon);

/// Whether `point` is inside. On the edge itself either result is possible.
[[nodiscard]] bool contains(std::span<const Point> polygon, Point point);

[[nodiscard]] double distance_to_segment(Point point, Point a, Point b);

/// No two edges meet except neighbours at their common vertex, and no edge has length zero.
[[nodiscard]] bool is_simple(std::span<const Point> polygon);

/// The corners of a box, counter-clockwise.
[[nodiscard]] Polygon corners(const Box& box);

/// The vertices of an outline, counter-clockwise.
[[nodiscard]] Polygon counter_clockwise(const Outline& outline);

/// Thickness of the boxes of a ring.
inline constexpr double kRingThickness = 0.2;

/// An outline as used by physics: one box inside each edge, its outer face on the edge.
///
/// At an acute corner the boxes are shortened where they would protrude from the other edge; a thinner pair
/// continues nearly to the tip. The ring is hollow; nothing gets in because its boxes touch at every vertex.
/// @pre the outline is simple
[[nodiscard]] std::vector<Box> ring_of_boxes(const Outline& outline);

}  // namespace caravan::world
