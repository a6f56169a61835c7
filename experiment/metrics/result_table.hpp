// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// What a run came to, for a person: several lines of at most 100 columns.
[[nodiscard]] std::string result_table(const RunFacts& facts, const Result& result, const RunEnd& end);

}  // namespace caravan::experiment
