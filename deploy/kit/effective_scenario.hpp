// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "runtime/config/setting.hpp"

namespace caravan::deploy {

/// The text of a scenario overridden by `changes`, itself TOML: tables key by key, everything else as a
/// whole.
///
/// Paths of controllers start from the folder of the scenario, and are absolute in the text.
/// @param controller  takes the place of `controller.library`; empty: nothing does
/// @throws runtime::StartError when either cannot be read
[[nodiscard]] std::string with_changes(const std::filesystem::path& scenario, const std::string& changes,
                                       const std::string& controller = {});

/// Such changes with more of them.
/// @throws runtime::StartError as runtime::apply()
[[nodiscard]] std::string with_settings(const std::string& changes, const runtime::Settings& settings);

}  // namespace caravan::deploy
