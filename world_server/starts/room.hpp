// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// What keeps a robot from standing at `place`, however it is turned: a wall, something solid or another
/// robot. Empty when there is room for it.
///
/// @param poses where the robots are, [0] is robot 1
[[nodiscard]] std::string obstacle_at(const WorldConfig& config, std::span<const Pose> poses,
                                      std::uint32_t robot, const Pose& place);

}  // namespace caravan::world
