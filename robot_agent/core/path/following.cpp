// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/following.hpp"

#include <algorithm>
#include <cmath>

#include "robot_agent/core/angle.hpp"
#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

bool has_passed(const Point& from, const Point& to, const Point& p_WB, double passed_m) {
  if ((p_WB - to).squaredNorm() < passed_m * passed_m) return true;
  return (p_WB - to).dot(to - from) >= 0.0;
}

/// Index of the last vertex in which a robot that has lost the path searches for it.
std::size_t end_of_search(std::span<const Point> path, std::size_t next, double ahead_m) {
  double length = 0.0;
  std::size_t i = next;
  for (; i + 1 < path.size() && length < ahead_m; ++i) length += (path[i + 1] - path[i]).norm();
  return i;
}

bool turns_by_more(const Point& a, const Point& b, const Point& c, double turn_rad) {
  return std::abs(wrapped(angle_of(c - b) - angle_of(b - a))) > turn_rad;
}

}  // namespace

std::size_t next_location(std::span<const Point> path, std::size_t next, const Point& p_WB,
                          const PathFollowing& settings) {
  CARAVAN_ASSERT(path.size() >= 2 && next >= 1 && next < path.size());
  if (project(path.subspan(next - 1, 2), p_WB).distance_m > settings.lost_m) {
    const std::size_t first = next - 1 - std::min<std::size_t>(settings.search_back, next - 1);
    const std::size_t last = end_of_search(path, next, settings.search_ahead_m);
    next = first + project(path.subspan(first, last - first + 1), p_WB).segment + 1;
  }
  while (next + 1 < path.size() && has_passed(path[next - 1], path[next], p_WB, settings.passed_m)) ++next;
  return next;
}

std::size_t nearest_location(std::span<const Point> path, const Point& p_WB) {
  return project(path, p_WB).segment + 1;
}

Point look_ahead_point(std::span<const Point> path, std::size_t next, const Point& p_WB,
                       const PathFollowing& settings) {
  CARAVAN_ASSERT(path.size() >= 2 && next >= 1 && next < path.size());
  const Projection here = project(path.subspan(next - 1, 2), p_WB);
  double ahead = settings.look_ahead_m + settings.look_ahead_per_metre * here.distance_m;
  Point from = here.point;
  for (std::size_t i = next;; ++i) {
    const double length = (path[i] - from).norm();
    if (length >= ahead) return from + (ahead / length) * (path[i] - from);
    if (i + 1 == path.size() || turns_by_more(path[i - 1], path[i], path[i + 1], settings.sharp_turn_rad))
      return path[i];
    ahead -= length;
    from = path[i];
  }
}

}  // namespace caravan::agent
