// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// A robot that has told where it is and that this one is about to run into.
struct Meeting {
  Neighbour with;
  /// Distance at the closest point of approach when both keep their velocities, positive: it passes on the
  /// left. Both robots find the same.
  double passes_m = 0.0;
};

/// The velocity that this robot wants, frame B.
struct Velocity {
  double bearing_rad = 0.0;
  double speed_mps = 0.0;
};

/// The robot with the earliest closest point of approach of those that come towards this one, or stand in its
/// way, and would pass too near. One that drives ahead in the same direction, or crosses, is not met: it is
/// let go.
///
/// @param keep_clear_m  between the bodies
[[nodiscard]] std::optional<Meeting> find_meeting(const Velocity& wanted, const Perception& seen,
                                                  const MeetingRule& rule, const Body& body,
                                                  double keep_clear_m);

}  // namespace caravan::agent
