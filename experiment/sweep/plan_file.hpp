// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "experiment/sweep/design.hpp"

namespace caravan::experiment {

/// Reads the plan of a sweep; docs/sweeps.md describes the file.
/// @throws runtime::StartError `file:line: key: reason`
[[nodiscard]] Design read_plan(const std::filesystem::path& file);

}  // namespace caravan::experiment
