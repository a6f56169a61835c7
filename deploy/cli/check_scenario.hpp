// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/metrics/run_facts.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// Everything that any process would refuse in the scenario, and a start area too full for the robots, is
/// refused here, before anything is started.
/// @throws runtime::StartError `file:line: key: reason`
/// @return what is known of a run of it; the engine is left empty
[[nodiscard]] experiment::RunFacts check_scenario(const runtime::TomlDocument& scenario);

}  // namespace caravan::deploy
