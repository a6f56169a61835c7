// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Describes what prevents a robot from standing at `place` in any orientation: a wall, a solid or another
/// robot. Empty if there is room for it.
///
/// @param poses poses of the robots, [0] is robot 1
[[nodiscard]] std::string obstacle_at(const WorldConfig& config, std::span<const Pose> poses,
                                      std::uint32_t robot, const Pose& place);

}  // namespace caravan::world
