// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <caravan/condition.hpp>
#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// One `[[step]]` of a script: pause the world, wait, act, expect, in this order; each part is optional.
struct ScriptStep {
  std::string name;
  std::optional<std::uint64_t> at_step;  ///< pause the world before this step
  std::optional<Condition> when;         ///< wait for this before acting
  std::vector<std::string> actions;
  std::optional<Condition> expectation;
  std::chrono::milliseconds within{10'000};  ///< wall time for each of the two conditions
};

struct Script {
  std::string name;
  std::filesystem::path scenario;
  std::string changes;         ///< TOML that overrides the scenario
  runtime::Settings settings;  ///< override it after them
  double lease_s = 2.0;
  bool hold_start = false;
  std::uint32_t agents_per_process = 1;
  std::vector<ScriptStep> steps;
};

/// Reads a script strictly: every key, action and condition is checked before anything starts.
/// @param settings  for Script::settings
/// @throws runtime::StartError `file:line: key: reason`
[[nodiscard]] Script load_script(const std::filesystem::path& file, const runtime::Settings& settings = {});

/// The scenario with the changes and the settings.
/// @param controller  as in with_changes()
/// @throws runtime::StartError when it cannot be read
[[nodiscard]] runtime::TomlDocument scenario_of(const Script& script, const std::string& controller = {});

}  // namespace caravan::deploy
