// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>

#include "runtime/config/toml_table.hpp"
#include "runtime/controller/library.hpp"

namespace caravan::runtime {

/// A controller for `robot`, with the keys of `table` (`[controller]`) that nobody has read yet as its
/// parameters, and the path of its file as `library`.
///
/// @throws StartError when its constructor throws, makes none, or does not ask for one of the keys
[[nodiscard]] std::unique_ptr<Controller> make_controller(const LoadedController& loaded, const Robot& robot,
                                                          TomlTable table);

}  // namespace caravan::runtime
