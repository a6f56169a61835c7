// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of paths. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// The path that an exploring robot leaves behind it.
struct RecordingSettings {
  double spacing_m = 1.0;       ///< between vertices
  double sharp_turn_rad = 0.8;  ///< one more where the heading has changed by this since the last,
  double shortest_m = 0.25;     ///< but not nearer to it

  bool operator==(const RecordingSettings&) const = default;
};

/// Pure pursuit of a path (Coulter 1992), and getting back to it.
struct PathFollowing {
  double look_ahead_m = 0.6;          ///< to the look-ahead point, along the path,
  double look_ahead_per_metre = 0.5;  ///< and so much more for each metre off the path,
  double sharp_turn_rad = 0.5;        ///< but not round a vertex that turns by more than this
  double passed_m = 0.25;             ///< a vertex is passed this near to it
  double lost_m = 0.75;               ///< farther off the path the robot looks for it again,
  std::uint32_t search_back = 3;      ///< so many vertices back
  double search_ahead_m = 6.0;        ///< and so far ahead
  double return_reached_m = 0.35;  ///< a point of the way back from a blocked shortcut is reached this near
  double pick_up_m = 0.6;          ///< an old section this near is picked up at once
  double end_m = 2.0;              ///< a shortcut to the end of the path, this near to it, has been driven

  bool operator==(const PathFollowing&) const = default;
};

/// Algorithm 4.
struct Smoothing {
  double vision_radius_m = 6.0;           ///< vertices within it are candidates
  double gain_m = 0.05;                   ///< a shortcut that saves less is not worth it
  Time pause = std::chrono::minutes{10};  ///< before a shortcut that was blocked is tried again
  double interval_m = 0.25;               ///< of travel between two searches
  double on_path_m = 0.6;                 ///< a shortcut begins this near to the path
  double merge_m = 0.3;                   ///< a vertex this near behind its beginning is left out
  // A shortcut on a shortcut must be worth more: each one puts off the moment when all are driven.
  double nested_gain_m = 0.4;
  double provisional_m = 8.0;  ///< with so much to drive of them, none is added
  double alike_m = 1.0;        ///< between the ends of two shortcuts that count as the same
  double touch_room_m = 0.45;  ///< a shortcut keeps so far from a place of touch
  double bend_room_m = 0.05;   ///< a bend of the path, and so much more than a shortcut's corridor

  bool operator==(const Smoothing&) const = default;
};

}  // namespace caravan::agent
