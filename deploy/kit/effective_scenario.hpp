// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace caravan::deploy {

/// The text of a scenario overridden by `changes`, itself TOML: tables key by key, everything else as a
/// whole.
///
/// Paths of controllers start from the folder of the scenario, and are absolute in the text.
/// @param controller  takes the place of `controller.library`; empty: nothing does
/// @throws runtime::StartError when either cannot be read
[[nodiscard]] std::string with_changes(const std::filesystem::path& scenario, const std::string& changes,
                                       const std::string& controller = {});

}  // namespace caravan::deploy
