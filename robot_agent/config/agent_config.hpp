// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::agent {

/// Reads `[robots]`, `[radio]`, `[algorithm]` and `seed`; never `[world]`.
/// @throws StartError for a bad value or key, or when `robot` is not in 1 .. robots.count
[[nodiscard]] Config load_config(const runtime::TomlDocument& scenario, std::uint32_t robot);

}  // namespace caravan::agent
