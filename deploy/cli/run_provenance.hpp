// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "deploy/cli/command_line.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/provenance/provenance.hpp"

namespace caravan::deploy {

/// The seeds of a scenario by key: `seed`, and every other whole number whose key is, or ends with, `seed`,
/// such as a parameter of a controller.
[[nodiscard]] std::map<std::string, std::uint64_t> seeds_in(const runtime::TomlDocument& scenario);

/// What is about to make a run.
/// @param scenario  effective; `text` is its text
/// @param agent     program in the place of robot_agent; empty: none
/// @throws runtime::StartError when the file of the controller or of the agent cannot be read
[[nodiscard]] runtime::Provenance provenance_of(const RunCommand& command,
                                                const runtime::TomlDocument& scenario,
                                                const std::string& text, const std::filesystem::path& agent);

}  // namespace caravan::deploy
