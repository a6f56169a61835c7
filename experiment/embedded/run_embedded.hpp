// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/run_request.hpp"

namespace caravan::experiment {

/// Runs the experiment with all cores in this process, as fast as possible (in real time when its pacing is
/// realtime or free: here the two are the same), and returns when it is over.
///
/// @return the exit code of `caravan run`
/// @throws runtime::StartError
[[nodiscard]] int run_embedded(const RunRequest& request);

}  // namespace caravan::experiment
