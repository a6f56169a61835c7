// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include "robot_agent/core/sensing/patience.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/sensing/surface_map.hpp"

namespace caravan::agent {

/// Remembers surfaces near by that are not robots.
///
/// Corners and oblique walls return no echo. But the walls that meet in a corner did so before the robot came
/// beside it, and a wall that a sonar follows is likely to go on a little. Places of echoes are kept for
/// SurfaceMemory::recent, and in a map for SurfaceMemory::duration; the continuation of a wall only while a
/// sonar follows it. A robot without progress forgets what the map has around it.
class Surfaces {
 public:
  /// @param recognises_high  whether is_high() will be used
  Surfaces(const SurfaceMemory& memory, const PatienceSettings& patience, bool recognises_high);
  /// Adds the echoes of this step. Removes places around robots of known position: the echo was that robot's.
  void see(const Perception& seen);
  /// Adds a surface in front of the robot, which drove forward without moving.
  void touch_ahead(const Perception& seen, const Body& body);
  /// True when something near this place is as high as the sonars, because they saw it from close by.
  /// @pre recognises_high
  [[nodiscard]] bool is_high(const Point& at_W) const { return map_.is_high(at_W); }
  /// Radius within which near() finds places.
  [[nodiscard]] double reach_m() const { return memory_.reach_m; }
  /// Places in W within reach_m() of the robot: what it can hit while it drives and brakes.
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
  std::vector<Point> extended_;                // expected continuation of walls that sonars follow now
  std::array<Place, kSonarCount> followed_{};  // an earlier echo of each sonar, some centimetres back
};

}  // namespace caravan::agent
