// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/movement.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// What a robot may do, and why no more.
struct Allowed {
  Wheels wheels;
  bool surface_near = false;  ///< the wanted movement would come too near to something that is no robot
};

/// Keeps robots apart from each other and from what stands still, whatever this one is about to do.
///
/// A movement is safe when the robot could follow it for a moment, then brake, and would not have come too
/// near to any robot that has told where it is and does the same. Too near is: less than config.keep_clear_m
/// between the bodies; or the axles so close that one could not turn on the spot beside the other. Who is too
/// near already shall not come nearer by more than a little. The same holds for the body and the places in
/// seen.surfaces, where 4 cm are enough: these do not move. Who touches one may drive along it.
///
/// Returned is the wanted movement when it is safe, else the safe one most like it, standing included; when
/// none is safe, the least bad. It does not drive forwards or backwards into an echo to keep clear.
///
/// @param now how the robot moves at present
[[nodiscard]] Allowed keep_clear(const Wheels& wanted, const Movement& now, const Perception& seen,
                                 const Config& config);

}  // namespace caravan::agent
