// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent {

/// Algorithm 2, GenerateNewLocationToExplore(): a direction is drawn near the heading; while the sonars see
/// something in the way to it, from a wider and wider range.
///
/// @return the new location in W, Exploration::step_m away. When no direction is free it is the freest
/// of those tried.
[[nodiscard]] Point new_location_to_explore(const Perception& seen, const Exploration& exploration,
                                            const Passage& passage, const Body& body, pure::Random& random);

}  // namespace caravan::agent
