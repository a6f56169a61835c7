// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/path/refusals.hpp"
#include "robot_agent/core/path/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// True when the robot can drive straight to a point, by its sonars: the bearing is in the front fan, and a
/// corridor of Passage::corridor_m up to the point has no echo. Beyond the range of the sonars, and where a
/// surface returns no echo, free space is an assumption. Therefore a shortcut is provisional until it is
/// driven.
[[nodiscard]] bool is_reachable(const Perception& seen, const Point& candidate, const Passage& passage,
                                const Body& body);

/// The section of a path ahead of the robot.
struct Ahead {
  std::span<const Point> plan;       ///< the whole path in the order of travel
  std::span<const double> to_end_m;  ///< distance from each vertex to the end
  std::size_t next = 0;              ///< vertex that the robot drives to
};

/// Criteria for a vertex ahead to be a candidate.
struct ShortcutSearch {
  double vision_radius_m = 6.0;
  double least_gain_m = 0.05;  ///< smallest saving of a shortcut
  Passage passage;             ///< corridor that must be free
  Body body;
};

struct Shortcut {
  std::size_t candidate = 0;  ///< index of the vertex that it leads to
  double gain_m = 0.0;        ///< length that it saves
};

/// Algorithm 4, Modified ApplyPathSmoothing(), lines 1 to 16: of the reachable vertices ahead within
/// ShortcutSearch::vision_radius_m, the one that saves most. Works in both directions, because the plan is in
/// the order of travel.
///
/// @param refusals  shortcuts that must not be tried
[[nodiscard]] std::optional<Shortcut> find_shortcut(const Ahead& ahead, const Perception& seen,
                                                    const ShortcutSearch& search, const Refusals& refusals);

/// A plan with a shortcut.
struct Shortened {
  Path path;
  std::size_t next = 0;  ///< index of the first vertex after the shortcut's beginning
  std::size_t last = 0;  ///< index of the candidate
};

/// Lines 17 and 18: replaces the vertices before the candidate by new ones on the straight line from the
/// robot to it.
///
/// @param at         position of the robot; becomes a vertex
/// @param spacing_m  between the new vertices
/// @param merge_m    a vertex this near behind `at` is left out
[[nodiscard]] Shortened with_shortcut(const Ahead& ahead, const Point& at, std::size_t candidate,
                                      double spacing_m, double merge_m);

}  // namespace caravan::agent
