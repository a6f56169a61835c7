// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot_agent/core/sensing/settings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A strip from the robot's base along a bearing that the robot would like to drive.
struct Corridor {
  double bearing_rad = 0.0;    ///< in frame B: 0 ahead, positive to the left
  double half_width_m = 0.25;  ///< on either side of the line
  /// How far beyond the echo's point a surface is taken to reach on either side, across the sonar's axis: the
  /// sonar says how far, not where in its cone, and a wall goes on beside the spot that reflects.
  double surface_m = 0.0;
  double surface_per_metre = 0.2;  ///< the same, growing with the range
  double beyond_m = 0.0;           ///< what ends nearer, along the bearing, does not count
};

/// One sonar's echo.
struct Echo {
  Point p_B{0.0, 0.0};       ///< on the sonar's axis
  Point across_B{0.0, 0.0};  ///< unit vector across the axis
  double range_m = 0.0;
  std::size_t sonar = 0;  ///< which one's
};

/// What the sonars say about free space around the robot.
///
/// An echo is a surface across its sonar's axis. No echo is taken for free space, as far as the sonar sees:
/// surfaces at more than the reflection angle and corners return none, so free space here is a belief.
class Surroundings {
 public:
  Surroundings(const Sensors& sensors, const Sonars& sonars);

  /// The same without the echoes at places (frame B) for which `is_of_a_robot` holds: what is left is no
  /// robot that told where it is.
  template <typename IsOfARobot>
  [[nodiscard]] Surroundings without(const IsOfARobot& is_of_a_robot) const {
    Surroundings rest = *this;
    rest.count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!is_of_a_robot(echoes_[i].p_B)) rest.echoes_[rest.count_++] = echoes_[i];
    }
    return rest;
  }
  /// Takes places that the robot touched, frame B, for surfaces that reach so far around them.
  void add_touched(std::vector<Point> places_B, double margin_m) {
    touched_B_ = std::move(places_B);
    margin_m_ = margin_m;
  }

  /// By sonar, without the places touched.
  [[nodiscard]] std::span<const Echo> echoes() const { return {echoes_.data(), count_}; }
  /// Distance from the base along the corridor's line to the first surface inside the corridor; +inf: none.
  [[nodiscard]] double clearance_m(const Corridor& corridor) const;
  /// True when the bearing lies in the gapless fan of the six front sonars.
  [[nodiscard]] bool in_front_fan(double bearing_rad) const;
  /// How much further a surface can reach across a sonar's axis for each metre of range: half its cone.
  [[nodiscard]] double cone_per_metre() const { return cone_per_metre_; }
  /// True when no front sonar works: the robot cannot drive.
  [[nodiscard]] bool is_blind() const { return blind_; }

 private:
  std::array<Echo, kSonarCount> echoes_;
  std::size_t count_ = 0;
  std::vector<Point> touched_B_;
  double margin_m_ = 0.0;
  bool blind_ = true;
  double fan_rad_;
  double cone_per_metre_;
};

}  // namespace caravan::agent
