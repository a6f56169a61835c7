// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "robot_agent/core/angle.hpp"

namespace caravan::agent {
namespace {

struct Outline {
  Point centre;
  Point along;  // unit vector forward
  double half_length;
  double half_width;

  Outline(const Pose& pose, const Body& body)
      : along{direction(pose.yaw_WB_rad)}, half_length{0.5 * body.length_m}, half_width{0.5 * body.width_m} {
    centre = pose.p_WB + (body.ahead_m - half_length) * along;
  }
  [[nodiscard]] Point across() const { return {-along.y(), along.x()}; }
  [[nodiscard]] double squared_distance(const Point& p_W) const {
    const Point from = p_W - centre;
    const double dx = std::max(0.0, std::abs(from.dot(along)) - half_length);
    const double dy = std::max(0.0, std::abs(from.dot(across())) - half_width);
    return dx * dx + dy * dy;
  }
  [[nodiscard]] std::array<Point, 4> corners() const {
    const Point l = half_length * along;
    const Point w = half_width * across();
    return {centre + l + w, centre + l - w, centre - l + w, centre - l - w};
  }
};

}  // namespace

double distance_m(const Pose& one, const Pose& other, const Body& body) {
  // For two disjoint rectangles, a corner of one is always among the nearest points.
  const Outline a{one, body};
  const Outline b{other, body};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point& corner : a.corners()) nearest = std::min(nearest, b.squared_distance(corner));
  for (const Point& corner : b.corners()) nearest = std::min(nearest, a.squared_distance(corner));
  return std::sqrt(nearest);
}

double distance_m(const Pose& pose, const Point& p_W, const Body& body) {
  return std::sqrt(Outline{pose, body}.squared_distance(p_W));
}

double signed_distance_m(const Pose& pose, const Point& p_W, const Body& body) {
  const Outline outline{pose, body};
  const Point from = p_W - outline.centre;
  const double dx = std::abs(from.dot(outline.along)) - outline.half_length;
  const double dy = std::abs(from.dot(outline.across())) - outline.half_width;
  if (dx <= 0.0 && dy <= 0.0) return std::max(dx, dy);
  return std::hypot(std::max(0.0, dx), std::max(0.0, dy));
}

}  // namespace caravan::agent
