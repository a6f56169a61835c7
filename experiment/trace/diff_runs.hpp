// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>

namespace caravan::experiment {

/// Compares the traces that two runs recorded with `--trace`, step by step, and names the first step, robot
/// and quantity in which they differ, with both values. Of a killed run it uses the whole steps.
///
/// @param one, other  folders of the runs
/// @return 0: equal; 1: they differ, also in length or number of robots
/// @throws runtime::StartError when a trace cannot be read
[[nodiscard]] int diff_runs(const std::filesystem::path& one, const std::filesystem::path& other,
                            std::FILE* out);

}  // namespace caravan::experiment
