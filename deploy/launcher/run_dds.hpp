// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/run_request.hpp"

namespace caravan::deploy {

/// Runs the experiment with world server, radio emulator and all agents as separate processes, and returns
/// when it is over.
///
/// @return the exit code of `caravan run`
/// @throws runtime::StartError when the processes cannot be started
[[nodiscard]] int run_dds(const experiment::RunRequest& request);

}  // namespace caravan::deploy
