// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "experiment/metrics/metric_table.hpp"

namespace caravan::experiment {

/// The metrics that are a column of runs.csv and a row of summary.csv, in this order.
[[nodiscard]] const std::vector<Metric>& quantities();

/// Their values in a run's metrics.json, in the same order; none if the run has no such number.
///
/// @throws std::exception when a value is missing or has the wrong type
[[nodiscard]] std::vector<std::optional<double>> values_in(const nlohmann::json& metrics);

}  // namespace caravan::experiment
