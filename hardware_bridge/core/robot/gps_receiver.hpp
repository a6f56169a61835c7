// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Position in W of an antenna on a robot.
[[nodiscard]] Point antenna_place(const Pose& robot, const Point& antenna_B);

/// An emulated GPS receiver on the robot: sends GGA and RMC once a period.
class GpsReceiver {
 public:
  explicit GpsReceiver(const ArenaPlace& arena, Time period = std::chrono::milliseconds{100})
      : projection_{arena}, period_{period} {}

  /// Sets the position of the antenna; not finite: no fix. @param measured  by any clock; used for the speed
  void sense(const Point& antenna_W, Time measured);
  /// The sentences that are due, with line ends; empty if none are.
  [[nodiscard]] std::string take_lines(Time now);
  [[nodiscard]] Time next_deadline() const { return due_; }

 private:
  ArenaProjection projection_;
  Time period_;
  Time due_{0};
  struct Sensed {
    Point antenna_W;
    Time at{0};
  };
  std::optional<Sensed> sensed_;
  std::optional<Sensed> told_;  // as in the last sentences
};

}  // namespace caravan::bridge
