// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

/// Algorithm 7 for two robots with a path each: between consecutive intersections the shorter section is
/// taken.
///
/// Intersections are those of intersections(), and both ends of the paths. They must come in the same order
/// along both paths. Where they do not, some are skipped: those whose omission gives the shortest result. A
/// change of paths that saves less than 2 mm (more where the paths touch without meeting exactly) is not
/// made.
///
/// The function is symmetric: merge(a, b) and merge(b, a) are equal vertex for vertex. The result is at most
/// as long as the shorter path, connected, and on the 1 mm grid. It begins and ends at ends of the paths. Its
/// vertices are vertices of both paths, and crossings rounded to the grid.
///
/// @pre vertices are finite, and each path has at least two. First vertices within 0.05 m of one another, and
/// last vertices too; otherwise the shorter path is returned (if only one is a path, that one)
[[nodiscard]] Path merge(const Path& own, const Path& other);

/// Algorithm 7 for the receiver: the path to use after an exchange.
///
/// A robot without a path takes the received one (lines 9 to 12). A robot with a path takes the merged one
/// (lines 1 to 6), if that saves at least `gain_m`.
///
/// @param own  empty: no path
/// @return none: keep what the robot has
[[nodiscard]] std::optional<Path> path_after_exchange(const Path& own, const Path& received, double gain_m);

}  // namespace caravan::agent
