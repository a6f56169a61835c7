// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

/// Algorithm 7 for two robots that both have a path: between consecutive intersections the shorter section
/// wins.
///
/// Intersections are proper crossings and vertices of one path within 0.05 m of the other; a collinear
/// overlap contributes its two ends (and vertices inside it, between which both sections are equally long).
/// Both ends of the paths count as intersections. They must come in the same order along both paths; where
/// they do not, the selection that gives the shortest result counts and others are skipped. A change of paths
/// that gains less than 2 mm (more, where the paths touch without meeting exactly) is not made.
///
/// The result is the same whichever of the two is `own` (merge(a, b) and merge(b, a) are equal vertex for
/// vertex), never longer than the shorter of the two, connected, on the 1 mm grid, and starts and ends where
/// `own` and `other` do. Its vertices are vertices of the two and crossings, these rounded to the grid.
///
/// @pre vertices finite, at least two in each path; first vertices within 0.05 m of one another, last ones
///      too; otherwise the shorter path is returned whole (of a path and none: the path)
[[nodiscard]] Path merge(const Path& own, const Path& other);

/// Algorithm 7 whole, from the receiver's side: the path to use from now, once one was received.
///
/// Without a path of its own a robot takes the received one (lines 9 to 12). With one it takes what the two
/// merge to (lines 1 to 6), when that saves at least `gain_m`.
///
/// @param own  empty: none
/// @return none: the robot goes on with what it has
[[nodiscard]] std::optional<Path> path_after_exchange(const Path& own, const Path& received, double gain_m);

}  // namespace caravan::agent
