// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <filesystem>

namespace caravan::runtime {

/// Loads a shared library with a controller. It stays loaded until the process ends, because controllers of
/// it may.
///
/// @throws StartError when the file is missing, is no shared library or needs others that are missing, has no
/// controller, or was built against another version of the interface
[[nodiscard]] const ControllerLibrary& load_controller(const std::filesystem::path& file);

}  // namespace caravan::runtime
