// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/intersections.hpp"

#include <algorithm>
#include <cmath>

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {
namespace {

/// Rounding a point to the 1 mm grid moves it by up to 0.71 mm: a path through it grows by up to 1.42 mm. The
/// rest of the 2 mm covers rounding errors in sums of lengths.
constexpr double kChange_m = 0.002;

/// A segment with its bounding box, enlarged by kTouch_m.
struct Segment {
  std::size_t index;
  Point from, to;
  Point low, high;
  double arc_m;  // of `from`
};

std::vector<Segment> segments_of(std::span<const Point> path) {
  std::vector<Segment> segments;
  segments.reserve(path.size());
  double arc_m = 0.0;
  const Point margin{kTouch_m, kTouch_m};
  for (std::size_t index = 0; index + 1 < path.size(); ++index) {
    const Point& from = path[index];
    const Point& to = path[index + 1];
    segments.push_back({index, from, to, from.cwiseMin(to) - margin, from.cwiseMax(to) + margin, arc_m});
    arc_m += (to - from).norm();
  }
  return segments;
}

bool boxes_overlap(const Segment& a, const Segment& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
         b.low.y() <= a.high.y();
}

double cross(const Point& u, const Point& v) { return u.x() * v.y() - u.y() * v.x(); }

Place inside(const Segment& segment, double fraction) {
  return {segment.arc_m + fraction * (segment.to - segment.from).norm(), segment.index, segment.index + 1};
}
/// @param end 0: the segment's first vertex, 1: its last
Place at_vertex(const Segment& segment, std::size_t end) {
  const std::size_t vertex = segment.index + end;
  return {segment.arc_m + (end == 1 ? (segment.to - segment.from).norm() : 0.0), vertex, vertex + 1};
}

/// A crossing strictly inside both segments. Vertices on a segment are found by touch().
std::optional<Intersection> crossing(const Segment& a, const Segment& b) {
  const Point u = a.to - a.from;
  const Point v = b.to - b.from;
  const double denominator = cross(u, v);
  if (denominator == 0.0) return std::nullopt;
  const double fraction_a = cross(b.from - a.from, v) / denominator;
  const double fraction_b = cross(b.from - a.from, u) / denominator;
  if (!(fraction_a > 0.0 && fraction_a < 1.0 && fraction_b > 0.0 && fraction_b < 1.0)) return std::nullopt;
  return Intersection{inside(a, fraction_a), inside(b, fraction_b), on_grid(a.from + fraction_a * u),
                      kChange_m};
}

/// The nearest point of `segment` to the vertex, if within kTouch_m.
struct Touch {
  double fraction;
  double distance_m;
};
std::optional<Touch> touch(const Point& vertex, const Segment& segment) {
  const Point along = segment.to - segment.from;
  const double squared = along.squaredNorm();
  const double fraction =
      squared > 0.0 ? std::clamp((vertex - segment.from).dot(along) / squared, 0.0, 1.0) : 0.0;
  const double distance_m = (segment.from + fraction * along - vertex).norm();
  if (!(distance_m <= kTouch_m)) return std::nullopt;
  return Touch{fraction, distance_m};
}

/// Adds the intersections of two segments. Each vertex is checked with the segment that ends at it, the first
/// vertex of a path with the segment that begins at it.
void add(const Segment& a, const Segment& b, std::vector<Intersection>& found) {
  if (const auto proper = crossing(a, b)) found.push_back(*proper);
  for (const std::size_t end : {0U, 1U}) {
    if (end == 0 && a.index != 0) continue;
    const Point& vertex = end == 0 ? a.from : a.to;
    if (const auto near = touch(vertex, b)) {
      found.push_back({at_vertex(a, end), inside(b, near->fraction), vertex, near->distance_m + kChange_m});
    }
  }
  for (const std::size_t end : {0U, 1U}) {
    if (end == 0 && b.index != 0) continue;
    const Point& vertex = end == 0 ? b.from : b.to;
    if (const auto near = touch(vertex, a)) {
      found.push_back({inside(a, near->fraction), at_vertex(b, end), vertex, near->distance_m + kChange_m});
    }
  }
}

bool lies_before(const Intersection& one, const Intersection& other) {
  if (one.on_a.arc_m != other.on_a.arc_m) return one.on_a.arc_m < other.on_a.arc_m;
  return one.on_b.arc_m < other.on_b.arc_m;
}

}  // namespace

std::optional<std::vector<Intersection>> intersections(std::span<const Point> a, std::span<const Point> b,
                                                       std::size_t limit) {
  const std::vector<Segment> segments_a = segments_of(a);
  const std::vector<Segment> segments_b = segments_of(b);
  std::vector<Intersection> found;
  for (const Segment& one : segments_a) {
    for (const Segment& other : segments_b) {
      if (boxes_overlap(one, other)) add(one, other, found);
      if (found.size() > limit) return std::nullopt;
    }
  }
  std::stable_sort(found.begin(), found.end(), lies_before);
  return found;
}

}  // namespace caravan::agent
