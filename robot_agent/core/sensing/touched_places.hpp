// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// Places where the robot has touched something that its sonars did not see. Kept for the whole run: the
/// sonars will not see what is too low or too oblique for them later either.
///
/// Bounded by ObstacleMemory::places: the place touched longest ago is dropped. A place inside the body's
/// outline is wrong and removed, so that a false place obstructs only once.
class TouchedPlaces {
 public:
  explicit TouchedPlaces(const ObstacleMemory& memory) : memory_{memory} {}

  /// Adds a place, frame W, with an obstacle beyond it. @return false: the place is known
  bool add(const Point& at_W, const Point& towards_W);
  /// Forgets places inside the body's outline.
  void stand_on(const Pose& pose, const Body& body);
  /// Forgets what lies around a place.
  void forget_around(const Point& p_W, double radius_m);
  /// Forgets the places, frame W, for which the condition holds.
  template <typename Condition>
  void forget_if(const Condition& holds) {
    std::erase_if(places_, [&](const Place& place) { return holds(place.at); });
  }
  [[nodiscard]] std::vector<Point> at(const Point& p_W, double radius_m) const;
  /// Centres of the touched obstacles, ObstacleMemory::margin_m beyond the places.
  [[nodiscard]] std::vector<Point> middles(const Point& p_W, double radius_m) const;
  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    Point at, middle;
  };
  ObstacleMemory memory_;
  std::vector<Place> places_;  // latest touched last
};

}  // namespace caravan::agent
