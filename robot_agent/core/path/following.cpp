// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/following.hpp"

#include <algorithm>
#include <cmath>

#include "robot_agent/core/angle.hpp"
#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

constexpr double kPassed_m = 0.25;     // a vertex is passed this near to it
constexpr double kOffPath_m = 0.75;    // beyond it the robot looks for its path again
constexpr std::size_t kLooksBack = 3;  // vertices
constexpr double kLooksAhead_m = 6.0;
constexpr double kSteersAhead_m = 0.6;
constexpr double kSharpTurn_rad = 0.5;

bool has_passed(const Point& from, const Point& to, const Point& p_WB) {
  if ((p_WB - to).squaredNorm() < kPassed_m * kPassed_m) return true;
  return (p_WB - to).dot(to - from) >= 0.0;
}

/// The end of the stretch of path in which a robot that has lost it looks.
std::size_t end_of_search(std::span<const Point> path, std::size_t next) {
  double length = 0.0;
  std::size_t i = next;
  for (; i + 1 < path.size() && length < kLooksAhead_m; ++i) length += (path[i + 1] - path[i]).norm();
  return i;
}

bool turns_sharply(const Point& a, const Point& b, const Point& c) {
  return std::abs(wrapped(angle_of(c - b) - angle_of(b - a))) > kSharpTurn_rad;
}

}  // namespace

std::size_t next_location(std::span<const Point> path, std::size_t next, const Point& p_WB) {
  CARAVAN_ASSERT(path.size() >= 2 && next >= 1 && next < path.size());
  if (project(path.subspan(next - 1, 2), p_WB).distance_m > kOffPath_m) {
    const std::size_t first = next - 1 - std::min(kLooksBack, next - 1);
    const std::size_t last = end_of_search(path, next);
    next = first + project(path.subspan(first, last - first + 1), p_WB).segment + 1;
  }
  while (next + 1 < path.size() && has_passed(path[next - 1], path[next], p_WB)) ++next;
  return next;
}

std::size_t nearest_location(std::span<const Point> path, const Point& p_WB) {
  return project(path, p_WB).segment + 1;
}

Point steering_point(std::span<const Point> path, std::size_t next, const Point& p_WB) {
  CARAVAN_ASSERT(path.size() >= 2 && next >= 1 && next < path.size());
  const Projection here = project(path.subspan(next - 1, 2), p_WB);
  double ahead = kSteersAhead_m + 0.5 * here.distance_m;
  Point from = here.point;
  for (std::size_t i = next;; ++i) {
    const double length = (path[i] - from).norm();
    if (length >= ahead) return from + (ahead / length) * (path[i] - from);
    if (i + 1 == path.size() || turns_sharply(path[i - 1], path[i], path[i + 1])) return path[i];
    ahead -= length;
    from = path[i];
  }
}

}  // namespace caravan::agent
