// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "runtime/config/toml_table.hpp"
#include "runtime/scenario/shared_tables.hpp"
#include "world_server/shapes/solids.hpp"

namespace caravan::world {

/// `[world]`, with the shared tables that it depends on.
struct WorldConfig {
  double step_s = 0.032;                      ///< simulated time of one step
  std::uint32_t substeps = 2;                 ///< physics steps per step
  std::array<double, 2> arena_m{50.0, 50.0};  ///< inner size, centred on the origin of W
  std::uint32_t arena_for_robots =
      0;  ///< number of robots for which arena_m is sized; 0: it is used as written
  double wall_height_m = 1.0;
  std::array<double, 2> start_low_m{};  ///< start area, its corners
  std::array<double, 2> start_high_m{};
  double start_spacing_m = 0.8;     ///< distance between any two robots at the start
  std::vector<Box> boxes;           ///< `[[world.box]]`
  std::vector<Cylinder> cylinders;  ///< `[[world.cylinder]]`
  std::vector<Outline> outlines;    ///< `[[world.outline]]`
  runtime::RobotsTable robots;
  runtime::ExperimentTable experiment;
  std::uint64_t seed = 1;
  /// From the command line, sorted: robots whose agents a bridge serves. The world serves them under
  /// rt/body_<i>.
  std::vector<std::uint32_t> bodies = {};
  [[nodiscard]] bool is_body(std::uint32_t robot) const {
    return std::binary_search(bodies.begin(), bodies.end(), robot);
  }
};

/// Distance of the body's farthest corner from the middle of the axle.
[[nodiscard]] double body_radius_m(const runtime::RobotsTable& robots);

/// Reads `[world] [robots] [experiment]` and `seed`, never `[algorithm]`.
///
/// @throws StartError `file:line: key: reason`, also for an inconsistent world: solids outside the arena,
/// outlines that cross themselves or are too thin, a source or destination inside something solid, a body
/// whose parts do not fit. With `experiment.items = 0` nothing is delivered and the destination may be
/// anywhere.
[[nodiscard]] WorldConfig load_world_config(const runtime::TomlDocument& scenario);

/// Reads WorldConfig::bodies from the command line.
///
/// @throws StartError for unknown robot numbers, and in any pacing but free: a robot behind a serial line
/// cannot take part in the lockstep
[[nodiscard]] std::vector<std::uint32_t> read_bodies(const std::vector<std::string>& lists,
                                                     const WorldConfig& config);

}  // namespace caravan::world
