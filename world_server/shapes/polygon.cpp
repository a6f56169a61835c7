// SPDX-License-Identifier: Apache-2.0
#include "world_server/shapes/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace caravan::world {
namespace {

Point next_of(std::span<const Point> polygon, std::size_t i) { return polygon[(i + 1) % polygon.size()]; }

constexpr double kTipThickness = 0.03;

/// Whether the closed segments ab and cd share a point.
bool meet(Point a, Point b, Point c, Point d) {
  const double abc = cross(b - a, c - a);
  const double abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c);
  const double cdb = cross(d - c, b - c);
  if (((abc > 0.0 && abd < 0.0) || (abc < 0.0 && abd > 0.0)) &&
      ((cda > 0.0 && cdb < 0.0) || (cda < 0.0 && cdb > 0.0))) {
    return true;
  }
  return distance_to_segment(a, c, d) == 0.0 || distance_to_segment(b, c, d) == 0.0 ||
         distance_to_segment(c, a, b) == 0.0 || distance_to_segment(d, a, b) == 0.0;
}

/// The length by which a box of this thickness is shortened at a corner between the directions `in` and `out`
/// of its edges (unit).
double cut_at(Point in, Point out, double thickness) {
  const bool convex = cross(in, out) > 0.0;
  const double back = -dot(in, out);  // cosine of the corner's inner angle
  if (!convex || back <= 0.0) return 0.0;
  return thickness * back / std::max(cross(in, out), 1e-9);
}

Box box_on_edge(Point begin, Point along, double from, double to, double thickness, double height_m) {
  const Point inward{-along.y, along.x};
  const Point centre = begin + 0.5 * (from + to) * along + 0.5 * thickness * inward;
  return {.centre_m = {centre.x, centre.y},
          .size_m = {to - from, thickness},
          .yaw_rad = std::atan2(along.y, along.x),
          .height_m = height_m};
}

}  // namespace

double signed_area(std::span<const Point> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], next_of(polygon, i));
  return 0.5 * twice;
}

bool contains(std::span<const Point> polygon, Point point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = next_of(polygon, i);
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

double distance_to_segment(Point point, Point a, Point b) {
  const Point ab = b - a;
  const double square = dot(ab, ab);
  const double along = square > 0.0 ? std::clamp(dot(point - a, ab) / square, 0.0, 1.0) : 0.0;
  return length(point - (a + along * ab));
}

bool is_simple(std::span<const Point> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = polygon[i];
    const Point b = next_of(polygon, i);
    const Point after = next_of(polygon, (i + 1) % n);
    if (a == b) return false;
    // A spike: the next edge runs back over this one.
    if (cross(b - a, after - b) == 0.0 && dot(b - a, after - b) < 0.0) return false;
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;
      if (meet(a, b, polygon[k], next_of(polygon, k))) return false;
    }
  }
  return true;
}

Polygon corners(const Box& box) {
  const double cosine = std::cos(box.yaw_rad);
  const double sine = std::sin(box.yaw_rad);
  const double hx = 0.5 * box.size_m[0];
  const double hy = 0.5 * box.size_m[1];
  const Point centre = to_point(box.centre_m);
  return {placed({hx, hy}, centre, cosine, sine), placed({-hx, hy}, centre, cosine, sine),
          placed({-hx, -hy}, centre, cosine, sine), placed({hx, -hy}, centre, cosine, sine)};
}

Polygon counter_clockwise(const Outline& outline) {
  Polygon polygon;
  for (const auto& pair : outline.points_m) polygon.push_back(to_point(pair));
  if (signed_area(polygon) < 0.0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

std::vector<Box> ring_of_boxes(const Outline& outline) {
  const Polygon polygon = counter_clockwise(outline);
  const std::size_t n = polygon.size();
  Polygon directions;
  for (std::size_t i = 0; i < n; ++i) {
    const Point edge = next_of(polygon, i) - polygon[i];
    directions.push_back((1.0 / length(edge)) * edge);
  }
  std::vector<Box> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const Point along = directions[i];
    const double whole = length(next_of(polygon, i) - polygon[i]);
    for (const double thickness : {kRingThickness, kTipThickness}) {
      const double from = cut_at(directions[(i + n - 1) % n], along, thickness);
      const double to = whole - cut_at(along, directions[(i + 1) % n], thickness);
      const bool is_acute = from > 0.0 || to < whole;
      if (to > from && (thickness == kRingThickness || is_acute)) {
        ring.push_back(box_on_edge(polygon[i], along, from, to, thickness, outline.height_m));
      }
    }
  }
  return ring;
}

}  // namespace caravan::world
