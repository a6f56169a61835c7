// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

/// Algorithm 7 for two robots that both have a path: between consecutive intersections the shorter section
/// wins.
///
/// Intersections are proper crossings and vertices of one path within 0.05 m of the other; a collinear
/// overlap contributes its two ends. They must come in the same order along both paths, others are skipped.
/// Both ends of the paths count as intersections. The result is the same whichever of the two is `own`
/// (merge(a, b) and merge(b, a) are equal vertex for vertex), never longer than the shorter of the two,
/// connected, on the 1 mm grid, and starts and ends where `own` and `other` do.
///
/// @pre at least two vertices each; first vertices within 0.05 m of one another, last ones too; otherwise the
/// shorter
///      path is returned whole
[[nodiscard]] Path merge(const Path& own, const Path& other);

}  // namespace caravan::agent
