// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/provenance/provenance.hpp"

namespace caravan::experiment {

/// One run of a sweep.
struct PlannedRun {
  std::string mode;
  std::uint64_t seed = 0;
  std::string scenario_text;             ///< required content of its scenario.toml
  std::string point = {};                ///< folder of its point below that of the sweep; empty: no axes
  std::vector<std::string> values = {};  ///< one for each axis of the sweep
  std::string controller_sha256 = {};    ///< of the file of its controller; empty: the paper's agent
};

/// The runs of a sweep, point by point, in each mode by mode, and within a mode seed by seed; a run's
/// position in it is its index.
struct SweepPlan {
  std::string scenario;       ///< its name
  std::string scenario_text;  ///< effective: the file with the command line's changes, its own mode and seed
  std::string engine;         ///< embedded, dds
  std::vector<std::string> modes;
  std::vector<std::uint64_t> seeds;  ///< ascending
  std::vector<PlannedRun> runs;
  std::vector<std::string> axes = {};  ///< keys of the scenario that differ between points
  std::vector<runtime::HashedFile> controllers =
      {};  ///< of all runs, each file once; none: the paper's agent
};

/// The folder of a run below that of its sweep: <mode>/seed_<n>, below <point> if the sweep has axes.
[[nodiscard]] inline std::filesystem::path folder_of(const PlannedRun& run) {
  return std::filesystem::path{run.point} / run.mode / ("seed_" + std::to_string(run.seed));
}

}  // namespace caravan::experiment
