// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/metrics/run_facts.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::experiment {

/// Reads every table but [controller] in the same way as the processes of a run.
/// @throws runtime::StartError `file:line: key: reason`
/// @return the facts of a run of the scenario; engine and controller are left empty
[[nodiscard]] RunFacts check_tables(const runtime::TomlDocument& scenario);

}  // namespace caravan::experiment
