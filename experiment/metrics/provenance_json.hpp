// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "runtime/provenance/provenance.hpp"

namespace caravan::experiment {

/// The value of the key `provenance` in metrics.json; docs/outputs.md describes it. Like the metrics, its
/// keys are added to, never renamed.
[[nodiscard]] nlohmann::ordered_json provenance_json(const runtime::Provenance& provenance);
/// @throws nlohmann::json::exception when a value is missing or has the wrong type
[[nodiscard]] runtime::Provenance read_provenance(const nlohmann::json& json);

/// For a record that may be moved away from its run's folder: the provenance, and the text of the effective
/// scenario, as JSON.
[[nodiscard]] std::string record_header(const runtime::Provenance& provenance, const std::string& scenario);

}  // namespace caravan::experiment
