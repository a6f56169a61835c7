// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <filesystem>
#include <string>

namespace caravan::runtime {

/// What drives robots, ready to be made.
struct LoadedController {
  std::filesystem::path file;
  const ControllerLibrary* library = nullptr;  ///< of the process; for a file of Python, its host
  std::string name;                            ///< in messages and results
};

/// Loads a shared library with a controller, or for a file that ends in ".py" the library that hosts Python.
/// It stays loaded until the process ends, because controllers of it may.
///
/// @throws StartError when the file is missing, is no shared library or needs others that are missing, has no
/// controller or no valid name, or was built against another version of the interface. A file of Python is
/// only looked for.
[[nodiscard]] LoadedController load_controller(const std::filesystem::path& file);

}  // namespace caravan::runtime
