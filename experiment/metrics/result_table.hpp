// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// The results of a run as readable text: several lines of at most 100 columns.
[[nodiscard]] std::string result_table(const RunFacts& facts, const Result& result, const RunEnd& end);

}  // namespace caravan::experiment
