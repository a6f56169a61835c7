// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A vertex of one path counts as being on the other within this distance. Part of the protocol, not a
/// setting: both partners must find the same intersections.
inline constexpr double kTouch_m = 0.05;

/// A place on a path where one can arrive from its beginning and leave towards its end.
struct Place {
  double arc_m = 0.0;           ///< from the path's first vertex, along it
  std::size_t last_before = 0;  ///< the last vertex on the way to the place (it may be the place)
  std::size_t next_after = 0;   ///< the next vertex on the way from it
};

/// Where two paths meet, and what changing from one to the other there costs.
struct Intersection {
  Place on_a;
  Place on_b;
  Point point{0.0, 0.0};  ///< the vertex of a path that changes there, on the 1 mm grid
  double cost_m = 0.0;    ///< at least the detour that changing adds
};

/// All proper crossings of the segments of two paths, and all vertices of one within kTouch_m of a segment of
/// the other. A collinear overlap contributes its ends and the vertices in it.
///
/// @return sorted by place along `a`, then along `b`; nothing when there are more than `limit`
/// @pre vertices are finite and on the 1 mm grid
[[nodiscard]] std::optional<std::vector<Intersection>> intersections(std::span<const Point> a,
                                                                     std::span<const Point> b,
                                                                     std::size_t limit);

}  // namespace caravan::agent
