// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>

#include "runtime/config/toml_table.hpp"

namespace caravan::runtime {

/// A controller of `library` for `robot`, with the keys of `table` (`[controller]`) that nobody has read yet
/// as its parameters.
///
/// @throws StartError when its constructor throws, or does not ask for one of the keys
[[nodiscard]] std::unique_ptr<Controller> make_controller(const ControllerLibrary& library,
                                                          const Robot& robot, TomlTable table);

}  // namespace caravan::runtime
