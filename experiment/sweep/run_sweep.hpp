// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "experiment/sweep/plan.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// A sweep as requested on the command line, checked.
struct SweepRequest {
  SweepPlan plan;
  std::filesystem::path folder;     ///< absolute
  std::size_t jobs = 1;             ///< number of parallel runs
  std::optional<std::size_t> task;  ///< index of the only run to execute, without tables
  bool summarise = false;           ///< writes the tables of existing runs, and executes none
  bool retry_failed = false;
  bool quiet = false;
  runtime::Loop& loop;  ///< reports SIGINT and SIGTERM
};

/// Executes the runs of the plan that have no result yet, each in its own process (so a crash is a failed run
/// in the table), and writes the tables after each.
///
/// @return 0: every run (with `task`: that run) is done; 1: some failed, or are missing with `summarise`;
/// 130:
///         interrupted; the same call continues
/// @throws runtime::StartError
/// @throws std::runtime_error when a file can no longer be written
[[nodiscard]] int run_sweep(const SweepRequest& request);

}  // namespace caravan::experiment
