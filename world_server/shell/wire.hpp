// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "world_server/types.hpp"
#include "world_server/world.hpp"

namespace caravan::world {

/// Converts the world's values to the wire. The caller sets `stamp` and `session`.
void to_wire(const Sensors& sensors, caravan_interfaces::msg::SensorFrame& frame);
void to_wire(const World& world, std::span<const std::uint32_t> members,
             caravan_interfaces::msg::WorldTruth& truth);

}  // namespace caravan::world
