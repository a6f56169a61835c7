// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

struct Bend {
  Path path;
  std::size_t first = 0;  ///< vertex of both paths at which the bend begins
  std::size_t last = 0;   ///< vertex of the new path at which it ends
};

/// Leads a path round places that are in its way: where it comes nearer than `clear_m` to one, it follows a
/// polygon around the circle of this radius, on the shorter side. Where it begins or ends in such a circle
/// it stays as it is.
///
/// @param from  vertex before which the path stays as it is
/// @return nothing when no place is in the way. @pre at least two vertices, from + 1 < path.size()
[[nodiscard]] std::optional<Bend> bent_round(const Path& path, std::size_t from,
                                             std::span<const Point> places, double clear_m);

}  // namespace caravan::agent
