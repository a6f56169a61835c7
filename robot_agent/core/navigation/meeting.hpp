// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// An imminent encounter with a robot of known position.
struct Meeting {
  Neighbour with;
  /// Signed distance at the closest point of approach if both keep their velocities; positive: the other
  /// passes on the left. Both robots compute the same value.
  double passes_m = 0.0;
};

/// The velocity that this robot wants, frame B.
struct Velocity {
  double bearing_rad = 0.0;
  double speed_mps = 0.0;
};

/// Finds the robot with the earliest closest point of approach (CPA), among those that come towards this one
/// or stand in its way and would pass too near. A robot that drives ahead in the same direction, or crosses,
/// does not count.
///
/// @param keep_clear_m  required clearance between the bodies
[[nodiscard]] std::optional<Meeting> find_meeting(const Velocity& wanted, const Perception& seen,
                                                  const MeetingRule& rule, const Body& body,
                                                  double keep_clear_m);

}  // namespace caravan::agent
