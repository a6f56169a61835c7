// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

/// Shortcuts that were blocked, and places where the robot touched something its sonars did not see. They are
/// not tried again for a time.
class Refusals {
 public:
  /// @param alike_m  distance of the ends below which two shortcuts count as the same
  /// @param touch_room_m  clearance of a shortcut from a place of touch
  Refusals(double alike_m, double touch_room_m) : alike_m_{alike_m}, touch_room_m_{touch_room_m} {}

  /// Refuses the shortcut between two points, because it was blocked.
  void refuse(const Point& from, const Point& to, Time until);
  /// Refuses shortcuts past this place, because the robot touched something there.
  void touched(const Point& at, Time until);
  /// Removes expired entries.
  void forget(Time now);
  /// True when the shortcut, in either direction, is like a refused one or passes too near to a place of
  /// touch.
  [[nodiscard]] bool refuses(const Point& from, const Point& to, Time now) const;

 private:
  struct Pair {
    Point from, to;
    Time until;
  };
  struct Place {
    Point at;
    Time until;
  };
  [[nodiscard]] bool are_alike(const Point& a, const Point& b) const {
    return (a - b).squaredNorm() < alike_m_ * alike_m_;
  }
  double alike_m_;
  double touch_room_m_;
  std::vector<Pair> pairs_;
  std::vector<Place> places_;
};

}  // namespace caravan::agent
