// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot_agent/core/sensing/settings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A strip from the robot's base along a bearing that the robot may drive.
struct Corridor {
  double bearing_rad = 0.0;    ///< in frame B: 0 ahead, positive to the left
  double half_width_m = 0.25;  ///< half of its width
  /// Assumed extent of a surface to either side of the echo, across the sonar's axis: a sonar measures the
  /// range but not the direction within its cone, and a wall extends beyond the spot that reflects.
  double surface_m = 0.0;
  double surface_per_metre = 0.2;  ///< its growth with the range
  double beyond_m = 0.0;           ///< surfaces that end before this distance along the bearing do not count
};

/// One sonar's echo.
struct Echo {
  Point p_B{0.0, 0.0};       ///< on the sonar's axis
  Point across_B{0.0, 0.0};  ///< unit vector across the axis
  double range_m = 0.0;
  std::size_t sonar = 0;  ///< index of the sonar
};

/// Free space around the robot, by its sonars.
///
/// An echo is a surface across its sonar's axis. Where there is no echo, space counts as free up to the
/// sonar's range. This is an assumption: corners, and surfaces beyond the reflection angle, return none.
class Surroundings {
 public:
  Surroundings(const Sensors& sensors, const Sonars& sonars);

  /// A copy without the echoes for whose position (frame B) `is_of_a_robot` holds. What remains is not a
  /// robot of known position.
  template <typename IsOfARobot>
  [[nodiscard]] Surroundings without(const IsOfARobot& is_of_a_robot) const {
    Surroundings rest = *this;
    rest.count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!is_of_a_robot(echoes_[i].p_B)) rest.echoes_[rest.count_++] = echoes_[i];
    }
    return rest;
  }
  /// Adds places that the robot touched, frame B, as discs of radius `margin_m`.
  void add_touched(std::vector<Point> places_B, double margin_m) {
    touched_B_ = std::move(places_B);
    margin_m_ = margin_m;
  }

  /// Sorted by sonar, without the touched places.
  [[nodiscard]] std::span<const Echo> echoes() const { return {echoes_.data(), count_}; }
  /// Distance from the base along the corridor's line to the first surface inside the corridor; +inf: none.
  [[nodiscard]] double clearance_m(const Corridor& corridor) const;
  /// True when the bearing is in the front fan, whose six sonars cover it without a gap.
  [[nodiscard]] bool in_front_fan(double bearing_rad) const;
  /// Half width of the sonar's cone per metre of range.
  [[nodiscard]] double cone_per_metre() const { return cone_per_metre_; }
  /// True when no front sonar works: the robot must not drive.
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
