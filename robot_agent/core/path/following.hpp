// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/path/settings.hpp"

namespace caravan::agent {

/// Algorithm 1, line 12: moving to the next location in the path. The path is in the order of travel and has
/// at least two vertices; `next` is the index of the vertex that the robot drives to, at least 1.

/// The new `next` after the vertices that the robot has passed. A robot farther from its path than
/// PathFollowing::lost_m rejoins it at the nearest point within a range around `next`.
[[nodiscard]] std::size_t next_location(std::span<const Point> path, std::size_t next, const Point& p_WB,
                                        const PathFollowing& settings);

/// Like next_location(), for a robot whose progress on the path is unknown: searches the whole path.
[[nodiscard]] std::size_t nearest_location(std::span<const Point> path, const Point& p_WB);

/// The look-ahead point of pure pursuit (Coulter 1992): the point to steer to, ahead on the path, but not
/// beyond a sharp corner.
[[nodiscard]] Point look_ahead_point(std::span<const Point> path, std::size_t next, const Point& p_WB,
                                     const PathFollowing& settings);

}  // namespace caravan::agent
