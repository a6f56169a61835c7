// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "runtime/config/toml_table.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::world {

/// A solid box on the floor, turned about its centre.
struct Box {
  std::array<double, 2> centre_m{};
  std::array<double, 2> size_m{1.0, 1.0};
  double yaw_rad = 0.0;
  double height_m = 1.0;
};

struct Cylinder {
  std::array<double, 2> centre_m{};
  double radius_m = 0.5;
  double height_m = 1.0;
};

/// A simple polygon, possibly concave; vertices in either direction of turning.
struct Outline {
  std::vector<std::array<double, 2>> points_m;
  double height_m = 1.0;
};

/// `[world]`, with the shared tables that it rests on.
struct WorldConfig {
  double step_s = 0.032;                      ///< simulated time of one step
  std::uint32_t substeps = 4;                 ///< physics steps in it
  std::array<double, 2> arena_m{50.0, 50.0};  ///< inner size, centred on the origin of W
  double wall_height_m = 1.0;
  std::array<double, 2> start_low_m{};  ///< start area, its corners
  std::array<double, 2> start_high_m{};
  double start_spacing_m = 0.8;     ///< between any two robots at the start
  std::vector<Box> boxes;           ///< `[[world.box]]`
  std::vector<Cylinder> cylinders;  ///< `[[world.cylinder]]`
  std::vector<Outline> outlines;    ///< `[[world.outline]]`
  runtime::RobotsTable robots;
  runtime::ExperimentTable experiment;
  std::uint64_t seed = 1;
};

/// Reads `[world] [robots] [experiment]` and `seed`, never `[algorithm]`.
[[nodiscard]] WorldConfig load_world_config(const runtime::TomlDocument& scenario);

}  // namespace caravan::world
