// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deploy/cli/command_line.hpp"
#include "experiment/sweep/plan.hpp"

namespace caravan::deploy {

/// The runs that the command requests, with each scenario checked. Without --modes all modes are compared,
/// and with axes, or another controller than the paper's, those of the scenario only.
///
/// @throws runtime::StartError for a bad scenario, --seeds or --modes
[[nodiscard]] experiment::SweepPlan plan_sweep(const SweepCommand& command);

}  // namespace caravan::deploy
