// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// Thrown when the process is told to stop before anything has started.
struct Interrupted {};

/// Makes a library's controller for each robot of the scenario, as the processes of a run will. A library is
/// loaded in a process of its own, because it can end, or keep, the process that loads it.
///
/// @param controller  as Controllers takes it
/// @return the controller's name
/// @throws runtime::StartError when one cannot be made, the library ends its process, or its loading, a
/// constructor or a destructor takes more than 10 s; Interrupted at a signal that a runtime::Loop has blocked
[[nodiscard]] std::string try_controllers(const runtime::TomlDocument& scenario,
                                          const std::string& controller);

}  // namespace caravan::deploy
