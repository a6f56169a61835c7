// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Where in W an antenna is that is mounted on a robot.
[[nodiscard]] Point antenna_place(const Pose& robot, const Point& antenna_B);

/// An emulated GPS receiver on the robot: GGA and RMC once a period.
class GpsReceiver {
 public:
  explicit GpsReceiver(const ArenaPlace& arena, Time period = std::chrono::milliseconds{100})
      : projection_{arena}, period_{period} {}

  /// Where the antenna is; not finite: no fix. @param measured  by any clock: its speed is reckoned with it
  void sense(const Point& antenna_W, Time measured);
  /// The sentences that are due, with line ends; empty when none are.
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
  std::optional<Sensed> told_;  // with the last sentences
};

}  // namespace caravan::bridge
