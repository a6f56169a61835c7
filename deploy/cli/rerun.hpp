// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include "deploy/cli/command_line.hpp"
#include "experiment/metrics/recorded_run.hpp"

namespace caravan::deploy {

/// A run that is to be repeated.
struct Rerun {
  experiment::RecordedRun recorded;
  RunCommand run;  ///< the repetition; it has a folder
};

/// Reads the folder of a run.
/// @throws runtime::StartError when it is not the folder of a run; when the run has no result that repeats;
/// and when the scenario, the controller or the agent is not what it was
[[nodiscard]] Rerun plan_rerun(const RerunCommand& command);

/// Compares the repetition, which has ended, with the run, and prints `equal` or `differs` with the digests,
/// then a line for everything that was different in what made them.
/// @return 0: equal, 1: not
[[nodiscard]] int judge_rerun(const Rerun& rerun, std::FILE* out);

}  // namespace caravan::deploy
