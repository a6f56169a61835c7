// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "world_server/config/world_config.hpp"
#include "world_server/shapes/scene.hpp"

/// What must hold between the values of a world. Each breach is a StartError at the line of a key.
namespace caravan::world {

/// The solid lies inside the arena.
void check_solid(const runtime::TomlTable& table, std::string_view key, const Solid& solid,
                 const WorldConfig& config);

/// A simple polygon that is nowhere thinner than the boxes of its ring.
void check_outline(const runtime::TomlTable& table, const Outline& outline);

/// Step and start area.
void check_world(const runtime::TomlTable& world, const WorldConfig& config);

/// The body's parts fit together, and source and destination can be reached in principle.
void check_robots(const runtime::TomlTable& robots, const WorldConfig& config);

}  // namespace caravan::world
