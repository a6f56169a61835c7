// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/types.hpp"

/// Parameters of paths. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// The path that an exploring robot records.
struct RecordingSettings {
  double spacing_m = 1.0;       ///< between vertices
  double sharp_turn_rad = 0.8;  ///< change of heading since the last vertex that adds a vertex
  double shortest_m = 0.25;     ///< smallest distance between such vertices

  bool operator==(const RecordingSettings&) const = default;
};

/// Pure pursuit of a path (Coulter 1992), and the way back to it.
struct PathFollowing {
  double look_ahead_m = 0.6;          ///< distance to the look-ahead point, along the path
  double look_ahead_per_metre = 0.5;  ///< its growth with the distance from the path
  double sharp_turn_rad = 0.5;        ///< the point does not lie beyond a vertex that turns by more
  double passed_m = 0.25;             ///< distance at which a vertex is passed
  double return_reached_m = 0.35;     ///< the same for a point of the way back from a blocked shortcut
  double lost_m = 0.75;               ///< distance from the path at which the robot searches for it again
  std::uint32_t search_back = 3;      ///< range of this search: vertices back
  double search_ahead_m = 6.0;        ///< and distance ahead
  double pick_up_m = 0.6;             ///< distance from the old section at which it is joined earlier
  double end_m = 2.0;  ///< from the end of the path, at which a shortcut to it counts as driven

  bool operator==(const PathFollowing&) const = default;
};

/// Algorithm 4.
struct Smoothing {
  double vision_radius_m = 6.0;           ///< vertices within it are candidates
  double gain_m = 0.05;                   ///< smallest saving of a shortcut
  Time pause = std::chrono::minutes{10};  ///< before a shortcut that was blocked is tried again
  double interval_m = 0.25;               ///< distance driven between two searches
  double on_path_m = 0.6;                 ///< largest distance from the path at which a shortcut begins
  double merge_m = 0.3;                   ///< a vertex this near behind its beginning is left out
  double nested_gain_m = 0.4;             ///< the same of a shortcut on a shortcut: it delays confirmation
  double provisional_m = 8.0;  ///< no shortcut is added beyond this length of the provisional section
  double alike_m = 1.0;        ///< distance of the ends below which two shortcuts count as the same
  double touch_room_m = 0.45;  ///< clearance of a shortcut from a place of touch
  double bend_room_m = 0.05;   ///< clearance of a bend from a touched obstacle, beyond half the corridor

  bool operator==(const Smoothing&) const = default;
};

}  // namespace caravan::agent
