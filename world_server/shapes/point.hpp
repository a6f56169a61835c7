// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

namespace caravan::world {

/// A point or vector of the floor plane, metres; frame W unless its name says otherwise.
struct Point {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Point&) const = default;
};

[[nodiscard]] constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] constexpr Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
[[nodiscard]] constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// Positive when b is to the left of a.
[[nodiscard]] constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
[[nodiscard]] inline double length(Point a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] constexpr Point to_point(const std::array<double, 2>& pair) { return {pair[0], pair[1]}; }
/// Transforms `local` from a frame at `origin`, turned by the angle of (cosine, sine), to the outer frame.
[[nodiscard]] constexpr Point placed(Point local, Point origin, double cosine, double sine) {
  return {origin.x + cosine * local.x - sine * local.y, origin.y + sine * local.x + cosine * local.y};
}

}  // namespace caravan::world
