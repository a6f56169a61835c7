// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "experiment/sweep/plan.hpp"
#include "experiment/sweep/run_row.hpp"

namespace caravan::experiment {

/// The state of a sweep.
enum class SweepState : std::uint8_t {
  kRunning,     ///< running, or killed
  kUnfinished,  ///< stopped with runs left to do
  kComplete     ///< every run is done or failed
};

// The files that a sweep writes in addition to its runs; docs/outputs.md describes keys and columns. `rows`
// corresponds to plan.runs.

[[nodiscard]] std::string sweep_json(const SweepPlan& plan, std::span<const RunRow> rows, SweepState state);
/// One row for each run, whatever its state.
[[nodiscard]] std::string runs_csv(const SweepPlan& plan, std::span<const RunRow> rows);
/// One row for each mode, at each point, and quantity, over the runs that are done; wall times are left out,
/// so the same sweep gives the same text.
[[nodiscard]] std::string summary_csv(const SweepPlan& plan, std::span<const RunRow> rows);
/// Text for the terminal: at each point each mode's time, round trips and routes, and the runs that failed.
[[nodiscard]] std::string sweep_table(const SweepPlan& plan, std::span<const RunRow> rows);

/// sweep.json, runs.csv and summary.csv in `folder`, each replaced atomically.
/// @throws std::runtime_error when one cannot be written
void write_tables(const std::filesystem::path& folder, const SweepPlan& plan, std::span<const RunRow> rows,
                  SweepState state);

}  // namespace caravan::experiment
