// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/config/toml_table.hpp"

namespace caravan::runtime {

/// The name of a scenario, which becomes part of a folder's name: its key `name`; without it, the name of its
/// file without extension, with _ in place of invalid characters.
/// @throws StartError when `name` has other characters than a-z, A-Z, 0-9, ._-, more than 64 of them, or none
[[nodiscard]] std::string name_of(const TomlDocument& scenario);

}  // namespace caravan::runtime
