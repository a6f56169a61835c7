// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "runtime/pure/angle.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::bridge {

/// Time since the process started. Callers pass it in; the core reads no clock.
using Time = std::chrono::nanoseconds;

using robot_model::kSonarCount;

/// A position in frame W, the arena's, metres.
struct Point {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// Pose of a robot's base in W.
struct Pose {
  Point p_WB;
  double yaw_WB_rad = 0.0;  ///< counter-clockwise from W's x axis, in (-pi, pi]
};

using pure::wrapped;

[[nodiscard]] inline double seconds(Time time) { return std::chrono::duration<double>(time).count(); }
[[nodiscard]] inline Time to_time(double seconds) { return Time{std::llround(seconds * 1e9)}; }

}  // namespace caravan::bridge
