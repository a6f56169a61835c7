// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// Distance within which a vertex of one path counts as on the other. Fixed by the protocol, not a setting:
/// both partners must find the same intersections.
inline constexpr double kTouch_m = 0.05;

/// A place on a path, between two vertices or at one.
struct Place {
  double arc_m = 0.0;           ///< distance from the path's first vertex, along the path
  std::size_t last_before = 0;  ///< last vertex up to the place (may be the place)
  std::size_t next_after = 0;   ///< first vertex behind it
};

/// A place where two paths meet, and the cost of changing paths there.
struct Intersection {
  Place on_a;
  Place on_b;
  Point point{0.0, 0.0};  ///< vertex of a path that changes here, on the 1 mm grid
  double cost_m = 0.0;    ///< upper bound of the detour that the change adds
};

/// All proper crossings of segments of two paths, and all vertices of one path within kTouch_m of a segment
/// of the other. A collinear overlap contributes its ends and the vertices inside it.
///
/// @return sorted by position along `a`, then along `b`; none when there are more than `limit`
/// @pre vertices are finite and on the 1 mm grid
[[nodiscard]] std::optional<std::vector<Intersection>> intersections(std::span<const Point> a,
                                                                     std::span<const Point> b,
                                                                     std::size_t limit);

}  // namespace caravan::agent
