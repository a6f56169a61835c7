// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// A robot that has told where it is and that this one is about to run into.
struct Meeting {
  Neighbour with;
  /// How far off it will pass, positive on the left, when both go on as they do. Both robots find the same.
  double passes_m = 0.0;
};

/// The robot nearest in time that comes towards this one or stands in its way, when it drives towards a
/// bearing (frame B). One that drives ahead in the same direction, or crosses, is not met: it is let go.
[[nodiscard]] std::optional<Meeting> find_meeting(double bearing_rad, double speed_mps,
                                                  const Perception& seen, const Config& config);

}  // namespace caravan::agent
