// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace caravan::deploy {

/// The text of a scenario overridden by `changes`, itself TOML: tables key by key, everything else as a
/// whole.
/// @throws runtime::StartError when either cannot be read
[[nodiscard]] std::string with_changes(const std::filesystem::path& scenario, const std::string& changes);

}  // namespace caravan::deploy
