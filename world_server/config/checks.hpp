// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "world_server/config/world_config.hpp"
#include "world_server/shapes/scene.hpp"

/// Constraints between the values of a world. Each breach is a StartError at the line of a key.
namespace caravan::world {

/// Checks that the solid is inside the arena.
void check_solid(const runtime::TomlTable& table, std::string_view key, const Solid& solid,
                 const WorldConfig& config);

/// Checks that it is a simple polygon, nowhere thinner than the boxes of its ring.
void check_outline(const runtime::TomlTable& table, const Outline& outline);

/// Checks step and start area.
void check_world(const runtime::TomlTable& world, const WorldConfig& config);

/// Checks that the body's parts fit together, and that source and destination are reachable in principle.
void check_robots(const runtime::TomlTable& robots, const WorldConfig& config);

}  // namespace caravan::world
