// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Start poses of the robots of a session: seeded by config.seed, at least start_spacing_m apart, at random
/// headings, clear of all solids, in the start area. When that is full it grows into the free ground around
/// it.
///
/// @throws runtime::StartError when the arena is full: no place is left on a lattice of 0.1 m
[[nodiscard]] std::vector<Pose> choose_starts(const WorldConfig& config);

}  // namespace caravan::world
