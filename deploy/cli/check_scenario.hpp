// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment/metrics/run_facts.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// Reads every table in the same way as the processes, and makes the controller of each robot
/// (try_controllers).
/// @param controller  as Controllers takes it
/// @throws runtime::StartError `file:line: key: reason`
/// @return the facts of a run of it; the engine is left empty
[[nodiscard]] experiment::RunFacts check_tables(const runtime::TomlDocument& scenario,
                                                const std::string& controller);

/// Like check_tables(), and builds the world once: everything that any process would refuse, including a
/// start area too full for the robots, is refused here, before anything starts.
/// @throws runtime::StartError
[[nodiscard]] experiment::RunFacts check_scenario(const runtime::TomlDocument& scenario);

}  // namespace caravan::deploy
