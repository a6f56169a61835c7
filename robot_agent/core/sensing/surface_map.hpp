// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// Where the sonars saw something that is no robot within the last minutes, wherever the robot is now.
///
/// Surfaces is a belief of seconds about what is beside the robot. A corner that points at the robot returns
/// no echo, but the faces that meet in it did when the robot last came by: the map is for these. It also
/// tells what is as high as the sonars: something lower returns an echo from a distance, where it lies in the
/// lower part of the cone, and none from close by.
class SurfaceMap {
 public:
  explicit SurfaceMap(const SurfaceMemory& memory) : memory_{memory} {}

  /// A sonar saw something here that is no robot. @param range_m  from the sonar
  void see(const Point& at_W, double range_m, Time now);
  /// The robot touched something here.
  void touch(const Point& at_W, Time now);
  /// True when something was seen from close by, ever, near this place: it is high.
  [[nodiscard]] bool is_high(const Point& at_W) const;
  struct Span {
    Time from, to;
  };
  /// Adds the places in W within reach of a body that drives and brakes that were seen then to `places`.
  void add_near(const Point& p_WB, const Span& seen, std::vector<Point>& places) const;
  void forget_around(const Point& p_W, double radius_m);
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    Point at{0.0, 0.0};
    Time seen{0};
    bool close = false;  // once seen from close by
  };
  using Square = std::pair<double, double>;  // whole numbers; no position overflows them
  [[nodiscard]] double square_of(double along_m) const;
  void remember(const Point& at_W, Time now, bool close);
  template <typename Visit>
  void visit_within(const Point& p_W, double radius_m, const Visit& visit) const;
  SurfaceMemory memory_;
  std::map<Square, Place> places_;
};

}  // namespace caravan::agent
