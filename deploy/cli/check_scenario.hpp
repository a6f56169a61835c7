// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/metrics/run_facts.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// Reads every table as the processes read them.
/// @throws runtime::StartError `file:line: key: reason`
/// @return what is known of a run of it; the engine is left empty
[[nodiscard]] experiment::RunFacts check_tables(const runtime::TomlDocument& scenario);

/// The same, and builds the world once: what any process would refuse, a start area too full for the robots
/// too, is refused here, before anything is started.
/// @throws runtime::StartError
[[nodiscard]] experiment::RunFacts check_scenario(const runtime::TomlDocument& scenario);

}  // namespace caravan::deploy
