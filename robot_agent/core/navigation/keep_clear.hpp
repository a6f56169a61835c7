// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/navigation/twist.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// What a robot may do, and why no more.
struct Allowed {
  Wheels wheels;
  bool surface_near = false;  ///< the wanted twist would come too near to something that is no robot
};

/// Keeps robots apart from each other and from what stands still, whatever this one is about to do.
///
/// A dynamic window (Fox, Burgard, Thrun 1997) over a small set of candidates. A twist is admissible when the
/// robot could follow it for a moment, then brake, and would not have come too near to any robot that has
/// told where it is and does the same. Too near is: less than KeepClear::robots_m between the bodies;
/// or the axles so close that one could not turn on the spot beside the other. Who is too near already shall
/// not come nearer by more than a little. The same holds for the body and the places in seen.surfaces, where
/// 4 cm are enough: these do not move. Who touches one may drive along it.
///
/// Returns the wanted twist when it is admissible, else the admissible one most like it, standing included;
/// when none is, the one with the least violation. It does not drive forwards or backwards into an echo to
/// keep clear.
///
/// @param now  the robot's twist at present
[[nodiscard]] Allowed keep_clear(const Wheels& wanted, const Twist& now, const Perception& seen,
                                 const KeepClear& settings, const Driving& driving, const Body& body);

}  // namespace caravan::agent
