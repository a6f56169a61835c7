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

/// Bends a path round places in its way. Where the path comes nearer than `clear_m` to a place, it follows a
/// polygon around the circle of that radius, on the shorter side. A path that begins or ends inside such a
/// circle is not changed there.
///
/// @param from  vertices up to this one stay
/// @return none when no place is in the way
/// @pre from + 1 < path.size() and clear_m > 0
[[nodiscard]] std::optional<Bend> bent_round(const Path& path, std::size_t from,
                                             std::span<const Point> places, double clear_m);

}  // namespace caravan::agent
