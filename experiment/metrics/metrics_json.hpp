// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// The text of metrics.json. External tools rely on its keys: keys are added, never renamed.
///
/// @param ended  false: an interim state, written in case the run never reaches its end
[[nodiscard]] std::string metrics_json(const RunFacts& facts, const Result& result, const RunEnd& end,
                                       bool ended = true);

}  // namespace caravan::experiment
