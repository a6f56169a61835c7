// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "radio_emulator/medium/medium.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::radio {

/// Reads `[radio]` and `seed`.
/// @throws runtime::StartError naming file, line and key
[[nodiscard]] MediumConfig load_radio_config(const runtime::TomlDocument& scenario);

}  // namespace caravan::radio
