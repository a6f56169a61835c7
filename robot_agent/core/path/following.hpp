// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/path/settings.hpp"

namespace caravan::agent {

/// Algorithm 1, line 12: moving to the next location in the path. The path is in the order of travel, at
/// least two vertices; `next` is the index of the vertex that the robot drives to, 1 or more.

/// The index to drive to after the vertices that the robot at `p_WB` has passed. A robot that was pushed off
/// its path picks it up again where it is nearest, not far from `next`.
[[nodiscard]] std::size_t next_location(std::span<const Point> path, std::size_t next, const Point& p_WB,
                                        const PathFollowing& settings);

/// The same when nothing is known of where the robot is on the path.
[[nodiscard]] std::size_t nearest_location(std::span<const Point> path, const Point& p_WB);

/// The look-ahead point of pure pursuit (Coulter 1992): where to steer, a little ahead along the path, but
/// never round a sharp corner.
[[nodiscard]] Point look_ahead_point(std::span<const Point> path, std::size_t next, const Point& p_WB,
                                     const PathFollowing& settings);

}  // namespace caravan::agent
