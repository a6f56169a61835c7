// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/recording.hpp"

#include <algorithm>
#include <cmath>

#include "robot_agent/core/angle.hpp"

namespace caravan::agent {
namespace {

/// The crossing of two segments, ends included; none for parallels.
std::optional<Point> crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point r = b - a;
  const Point s = d - c;
  const double denominator = cross(r, s);
  if (std::abs(denominator) < 1e-12) return std::nullopt;
  const double on_first = cross(c - a, s) / denominator;
  const double on_second = cross(c - a, r) / denominator;
  if (on_first < 0.0 || on_first > 1.0 || on_second < 0.0 || on_second > 1.0) return std::nullopt;
  return Point{a + on_first * r};
}

void add(Path& path, const Point& vertex) {
  if (path.empty() || path.back() != vertex) path.push_back(vertex);
}

}  // namespace

Recording::Recording(const Point& source, const RecordingSettings& settings)
    : path_{on_grid(source)}, settings_{settings} {}

void Recording::visit(const Point& p_WB, double yaw_WB_rad) {
  const double since = (p_WB - path_.back()).norm();
  const bool far = since >= settings_.spacing_m;
  const bool turned = std::abs(wrapped(yaw_WB_rad - last_yaw_WB_rad_)) > settings_.sharp_turn_rad &&
                      since >= std::min(settings_.shortest_m, settings_.spacing_m);
  if (started_ && !far && !turned) return;
  started_ = true;
  add(path_, on_grid(p_WB));
  last_yaw_WB_rad_ = yaw_WB_rad;
}

Path Recording::finished_at(const Point& p_WB, const Point& destination) const {
  Path path = path_;
  add(path, on_grid(p_WB));
  add(path, on_grid(destination));
  return path;
}

Path without_loops(const Path& path) {
  Path result;
  if (path.empty()) return result;
  result.push_back(path.front());
  std::size_t i = 0;
  while (i + 1 < path.size()) {
    const Point from = result.back();
    std::optional<Point> cut;
    std::size_t behind = i + 1;  // vertex after `from`, or after the cut
    // The last segment that crosses this one: removes the longest loop at once.
    for (std::size_t j = path.size() - 2; j > i + 1 && !cut; --j) {
      cut = crossing(from, path[i + 1], path[j], path[j + 1]);
      if (cut) behind = j + 1;
    }
    if (cut) add(result, on_grid(*cut));
    if (!cut) add(result, path[behind]);
    i = cut ? behind - 1 : behind;
  }
  if (result.size() < 2) result.push_back(path.back());
  return result;
}

}  // namespace caravan::agent
