// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/sweep/plan.hpp"

namespace caravan::experiment {

enum class RunState : std::uint8_t {
  kPending,  ///< not run yet, or ended half way: it is to be run
  kRunning,
  kDone,   ///< has a result, which may be that the time ran out
  kFailed  ///< could not be run or broke; stays in the table
};
[[nodiscard]] std::string to_text(RunState state);

/// One run as the table shows it.
struct RunRow {
  RunState state = RunState::kPending;
  std::string reason = {};                         ///< why it failed
  std::string digest = {};                         ///< of a run that is done
  std::vector<std::optional<double>> values = {};  ///< by quantities(); empty unless done
};

/// What the folder of a run says about it: failed when note_failure() left a reason in it, or metrics.json
/// tells of one or holds something else than a run writes; done when metrics.json is complete; everything
/// else is pending.
///
/// @throws runtime::StartError when the folder holds a run of another scenario, or one of its files, or the
///         folder itself, is something else
[[nodiscard]] RunRow look_at(const std::filesystem::path& sweep_folder, const PlannedRun& run);

/// Leaves the reason of a failure beside what the run wrote, for this and later sweeps to find.
void note_failure(const std::filesystem::path& sweep_folder, const PlannedRun& run,
                  const std::string& reason);

}  // namespace caravan::experiment
