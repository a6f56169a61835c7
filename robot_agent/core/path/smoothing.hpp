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

/// True when the sonars say that the robot can drive straight to a point: the bearing lies in the front fan
/// and no echo lies inside a corridor of Passage::corridor_m up to the point. Sonars see 5 m; beyond
/// that, and where a surface reflects nothing, free space is an assumption: what depends on it is
/// provisional.
[[nodiscard]] bool is_reachable(const Perception& seen, const Point& candidate, const Passage& passage,
                                const Body& body);

/// The part of a path that lies ahead, in the direction of travel.
struct Ahead {
  std::span<const Point> plan;       ///< the whole path in the order of travel
  std::span<const double> to_end_m;  ///< length from each vertex to the end
  std::size_t next = 0;              ///< the vertex that the robot drives to
};

/// What makes a vertex ahead a candidate.
struct ShortcutSearch {
  double vision_radius_m = 6.0;
  double least_gain_m = 0.05;  ///< a shortcut that saves less is none
  Passage passage;             ///< that must be free
  Body body;
};

struct Shortcut {
  std::size_t candidate = 0;  ///< index of the vertex that it leads to
  double gain_m = 0.0;        ///< how much shorter the way becomes
};

/// Algorithm 4, Modified ApplyPathSmoothing(), lines 1 to 16: of the vertices ahead within
/// ShortcutSearch::vision_radius_m that are reachable, the one that shortens the way most. The order of
/// travel makes it work in both directions.
///
/// @param refusals  shortcuts that are not tried again
[[nodiscard]] std::optional<Shortcut> find_shortcut(const Ahead& ahead, const Perception& seen,
                                                    const ShortcutSearch& search, const Refusals& refusals);

/// A path with a shortcut.
struct Shortened {
  Path path;
  std::size_t next = 0;  ///< index of the first vertex after the beginning of the shortcut
  std::size_t last = 0;  ///< index of the candidate
};

/// Lines 17 and 18: the path with new vertices on the straight line from where the robot is to the candidate,
/// in place of the old ones.
///
/// @param at         where the robot is; becomes a vertex
/// @param spacing_m  between the new vertices
/// @param merge_m    a vertex this near behind `at` is left out
[[nodiscard]] Shortened with_shortcut(const Ahead& ahead, const Point& at, std::size_t candidate,
                                      double spacing_m, double merge_m);

}  // namespace caravan::agent
