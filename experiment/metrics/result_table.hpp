// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deploy/metrics/metrics.hpp"
#include "deploy/metrics/run_facts.hpp"

namespace caravan::deploy {

/// What a run came to, for a person: several lines of at most 100 columns.
[[nodiscard]] std::string result_table(const RunFacts& facts, const Result& result, const RunEnd& end);

}  // namespace caravan::deploy
