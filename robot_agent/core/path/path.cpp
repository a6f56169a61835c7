// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/path.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

constexpr double kGridPerMetre = 1000.0;

Projection project_on(const Point& from, const Point& to, const Point& point) {
  const Point along = to - from;
  const double squared = along.squaredNorm();
  Projection result;
  if (squared > 0.0) result.fraction = std::clamp((point - from).dot(along) / squared, 0.0, 1.0);
  result.point = from + result.fraction * along;
  result.distance_m = (point - result.point).norm();
  return result;
}

}  // namespace

Point on_grid(const Point& point) {
  return {std::round(point.x() * kGridPerMetre) / kGridPerMetre,
          std::round(point.y() * kGridPerMetre) / kGridPerMetre};
}

double length_m(std::span<const Point> path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

Projection project(std::span<const Point> path, const Point& point) {
  CARAVAN_ASSERT(path.size() >= 2);
  Projection best = project_on(path[0], path[1], point);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    Projection next = project_on(path[i], path[i + 1], point);
    next.segment = i;
    if (next.distance_m < best.distance_m) best = next;
  }
  return best;
}

}  // namespace caravan::agent
