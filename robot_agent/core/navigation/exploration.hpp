// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent {

/// Algorithm 2, GenerateNewLocationToExplore(): draws a direction near the heading. The range of directions
/// widens with each draw whose way is not free by the sonars.
///
/// @return the new location in W, at distance Exploration::step_m; when no drawn direction is free, in the
/// direction with the most free space.
[[nodiscard]] Point new_location_to_explore(const Perception& seen, const Exploration& exploration,
                                            const Passage& passage, const Body& body, pure::Random& random);

}  // namespace caravan::agent
