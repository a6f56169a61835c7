// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/path/path.hpp"

namespace caravan::agent {

/// Shortcuts that turned out to be blocked, and the places where the robot touched what its sonars did not
/// see. Neither is tried again for a while.
class Refusals {
 public:
  /// @param alike_m  between the ends of two shortcuts that count as the same
  /// @param touch_room_m  kept from a place of touch
  Refusals(double alike_m, double touch_room_m) : alike_m_{alike_m}, touch_room_m_{touch_room_m} {}

  /// The shortcut between two points was blocked.
  void refuse(const Point& from, const Point& to, Time until);
  /// The robot touched something here.
  void touched(const Point& at, Time until);
  /// Forgets what is over.
  void forget(Time now);
  /// True when this shortcut, in either direction, is much like a refused one or leads past a place of touch.
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
