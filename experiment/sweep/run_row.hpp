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
  kPending,  ///< not run yet, or ended prematurely: still to be run
  kRunning,
  kDone,   ///< has a result, which may be that its time limit was reached
  kFailed  ///< could not start or crashed; stays in the table
};
[[nodiscard]] std::string to_text(RunState state);

/// One run as shown in the table.
struct RunRow {
  RunState state = RunState::kPending;
  std::string reason = {};                         ///< why it failed
  std::string digest = {};                         ///< digest of a run that is done
  std::vector<std::optional<double>> values = {};  ///< by quantities(); empty unless done
};

/// The state of a run according to its folder: failed when note_failure() left a reason in it, or
/// metrics.json contains a failure, values of the wrong type or another controller file than the plan; done
/// when metrics.json is complete; otherwise pending.
///
/// @throws runtime::StartError when the folder holds a run of another scenario, or when one of its files, or
/// the
///         folder itself, is something else
[[nodiscard]] RunRow look_at(const std::filesystem::path& sweep_folder, const PlannedRun& run);

/// Writes the reason of a failure into the run's folder, for this and later sweeps.
void note_failure(const std::filesystem::path& sweep_folder, const PlannedRun& run,
                  const std::string& reason);

}  // namespace caravan::experiment
