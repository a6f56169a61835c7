// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// A map of where the sonars saw something that is not a robot, during the whole run.
///
/// Surfaces itself covers the last seconds beside the robot. A corner that points at the robot returns no
/// echo, but its faces did when the robot last passed them: the map stores these. It also tells which
/// obstacles are as high as the sonars: a lower one returns an echo from a distance, where it is in the lower
/// part of the cone, and none from close by.
class SurfaceMap {
 public:
  explicit SurfaceMap(const SurfaceMemory& memory) : memory_{memory} {}

  /// Adds an echo that is not a robot's. @param range_m  from the sonar
  void see(const Point& at_W, double range_m, Time now);
  /// Adds a place that the robot touched.
  void touch(const Point& at_W, Time now);
  /// True when something near this place was ever seen from close by: it is as high as the sonars.
  [[nodiscard]] bool is_high(const Point& at_W) const;
  struct Span {
    Time from, to;
  };
  /// Appends to `places` those near `p_WB` (SurfaceMemory::reach_m), in W, that were last seen in the span.
  void add_near(const Point& p_WB, const Span& seen, std::vector<Point>& places) const;
  void forget_around(const Point& p_W, double radius_m);
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    Point at{0.0, 0.0};
    Time seen{0};
    bool close = false;  // was once seen from close by
  };
  using Square = std::pair<double, double>;  // integers; no position overflows them
  [[nodiscard]] double square_of(double along_m) const;
  void remember(const Point& at_W, Time now, bool close);
  template <typename Visit>
  void visit_within(const Point& p_W, double radius_m, const Visit& visit) const;
  SurfaceMemory memory_;
  std::map<Square, Place> places_;
};

}  // namespace caravan::agent
