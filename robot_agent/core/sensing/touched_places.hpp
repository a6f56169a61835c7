// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// Where the robot has touched something that its sonars did not see. Remembered for the whole run: what is
/// too low or too oblique for them does not show itself again.
///
/// Bounded by ObstacleMemory::places: of more, the one touched longest ago goes. A place that the body
/// stands on is wrong and goes as well, so that a false one is in the way only once.
class TouchedPlaces {
 public:
  explicit TouchedPlaces(const ObstacleMemory& memory) : memory_{memory} {}

  /// Something is at this place, frame W, and beyond it. @return false: it is known already
  bool add(const Point& at_W, const Point& towards_W);
  /// Forgets what the body stands on.
  void stand_on(const Pose& pose, const Body& body);
  /// Forgets what lies around a place.
  void forget_around(const Point& p_W, double radius_m);
  /// Forgets the places, frame W, for which it holds.
  template <typename Condition>
  void forget_if(const Condition& holds) {
    std::erase_if(places_, [&](const Place& place) { return holds(place.at); });
  }
  /// Places within so far.
  [[nodiscard]] std::vector<Point> at(const Point& p_W, double radius_m) const;
  /// Middles of what was touched there, ObstacleMemory::margin_m beyond the place.
  [[nodiscard]] std::vector<Point> middles(const Point& p_W, double radius_m) const;
  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    Point at, middle;
  };
  ObstacleMemory memory_;
  std::vector<Place> places_;  // the latest touched last
};

}  // namespace caravan::agent
