// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/pure/angle.hpp"
#include "world_server/config/world_config.hpp"

/// Worlds for tests.
namespace caravan::world {

/// The number of physics steps in a step of the shipped scenarios.
inline constexpr std::uint32_t kSubsteps = WorldConfig{}.substeps;

/// An empty square arena with the start area around its middle.
inline WorldConfig empty_world(double size_m, std::uint32_t robots) {
  WorldConfig config;
  config.arena_m = {size_m, size_m};
  config.start_low_m = {-1.0, -1.0};
  config.start_high_m = {1.0, 1.0};
  config.robots.count = robots;
  config.robots.source_m = {-0.4 * size_m, 0.0};
  config.robots.destination_m = {0.4 * size_m, 0.0};
  config.experiment.items = 0;
  return config;
}

inline std::uint64_t steps_in(double seconds) {
  return static_cast<std::uint64_t>(std::lround(seconds / 0.032));
}

using pure::wrapped;

inline constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace caravan::world
