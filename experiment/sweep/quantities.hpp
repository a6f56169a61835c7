// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace caravan::experiment {

/// A number that each run comes to: a column of runs.csv, and a row of summary.csv.
struct Quantity {
  std::string name;
  bool repeats = true;  ///< false: wall time, which the same run does not give again
};

/// In the order of the columns. docs/outputs.md says what they mean.
[[nodiscard]] std::span<const Quantity> quantities();

/// Their values in a run's metrics.json, in the same order; none where the run has no such number.
///
/// @throws std::exception when something is missing or of another kind
[[nodiscard]] std::vector<std::optional<double>> values_in(const nlohmann::json& metrics);

}  // namespace caravan::experiment
