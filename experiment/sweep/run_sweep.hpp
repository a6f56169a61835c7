// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "experiment/sweep/plan.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// A sweep as the command line asked for it, checked.
struct SweepRequest {
  SweepPlan plan;
  std::filesystem::path folder;     ///< absolute
  std::size_t jobs = 1;             ///< runs at a time
  std::optional<std::size_t> task;  ///< this run of the plan only, and no tables
  bool summarise = false;           ///< the tables of what is there, and no runs
  bool retry_failed = false;
  bool quiet = false;
  runtime::Loop& loop;  ///< says when SIGINT or SIGTERM came
};

/// Does the runs of the plan that have no result yet, each a process of its own (so the crash of one is a
/// failed run in the table), and writes the tables after each.
///
/// @return 0: every run (of the task: the run) is done; 1: some failed, or were not there to summarise; 130:
///         interrupted, the same call goes on
/// @throws runtime::StartError
/// @throws std::runtime_error when a file cannot be written any more
[[nodiscard]] int run_sweep(const SweepRequest& request);

}  // namespace caravan::experiment
