// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/navigation/twist.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// The wheel speeds that are allowed, and what limits them.
struct Allowed {
  Wheels wheels;
  bool surface_near = false;  ///< the wanted twist comes too near to a surface (not a robot)
};

/// Keeps the robot clear of other robots and of surfaces, whatever it is about to do.
///
/// A dynamic window (Fox, Burgard, Thrun 1997) over a small set of candidates. A twist is admissible if the
/// robot can follow it for KeepClear::command_s and then brake without coming too near to anything. Other
/// robots of known position are assumed to keep their twist and brake likewise. Too near to a robot means:
/// less than KeepClear::robots_m between the bodies, or axles so close that one robot could not turn in place
/// beside the other. If a robot is too near already, the distance must not shrink by more than a little.
/// Surfaces (seen.surfaces) need a clearance of KeepClear::surfaces_m. A robot in contact with a surface may
/// slide along it.
///
/// Returns the wanted twist if it is admissible, else the admissible candidate that is most like it, standing
/// still included. If none is admissible, the candidate with the smallest violation. Candidates must have
/// free space of KeepClear::echo_m in their direction of travel.
///
/// @param now  current twist of the robot
[[nodiscard]] Allowed keep_clear(const Wheels& wanted, const Twist& now, const Perception& seen,
                                 const KeepClear& settings, const Driving& driving, const Body& body);

}  // namespace caravan::agent
