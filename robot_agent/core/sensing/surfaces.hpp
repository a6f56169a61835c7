// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include "robot_agent/core/sensing/patience.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/sensing/surface_map.hpp"

namespace caravan::agent {

/// Remembers where something that is no robot stood near by.
///
/// Corners and oblique walls return no echo, but the walls that meet in a corner did so a moment before the
/// robot came beside it, and a wall that a sonar has followed goes on for a little. So what is known of a
/// place is more than what the sonars say at this moment. It is a belief of seconds; what lasts longer, for
/// SurfaceMemory::duration, comes from a map. A robot that gets nowhere forgets what the map holds around
/// it.
class Surfaces {
 public:
  /// @param recognises_high  is_high() is asked for
  Surfaces(const SurfaceMemory& memory, const PatienceSettings& patience, bool recognises_high);
  /// Takes in what the sonars see now. What lies where a robot has told to be is forgotten: it was that
  /// robot.
  void see(const Perception& seen);
  /// The robot drove forward and did not come forward: something unseen is in front of it.
  void touch_ahead(const Perception& seen, const Body& body);
  /// True when something near this place is as high as the sonars: they saw it from close by.
  /// @pre recognises_high
  [[nodiscard]] bool is_high(const Point& at_W) const { return map_.is_high(at_W); }
  /// Within it places are told.
  [[nodiscard]] double reach_m() const { return memory_.reach_m; }
  /// Places in W within reach of a body that drives and brakes.
  [[nodiscard]] std::vector<Point> near(const Point& p_WB, Time now) const;

 private:
  struct Place {
    Point at{0.0, 0.0};
    Time seen{-std::chrono::hours{1}};
  };
  void forget(const Perception& seen);
  void remember(const Place& place);
  void follow(std::size_t sonar, const Point& across_W, const Point& at, Time now);
  SurfaceMemory memory_;
  Patience patience_;
  bool has_map_;
  SurfaceMap map_;
  std::vector<Place> places_;
  std::vector<Point> extended_;                // where walls that sonars follow now should go on
  std::array<Place, kSonarCount> followed_{};  // an echo of each sonar some centimetres ago
};

}  // namespace caravan::agent
