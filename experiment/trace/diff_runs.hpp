// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>

namespace caravan::experiment {

/// Compares what two runs recorded with `--trace`, step by step, and names the first step, robot and quantity
/// in which they differ, with both values. Of a killed run it takes the whole steps.
///
/// @param one, other  folders of the runs
/// @return 0: equal; 1: they differ, be it in length or number of robots
/// @throws runtime::StartError when a trace cannot be read
[[nodiscard]] int diff_runs(const std::filesystem::path& one, const std::filesystem::path& other,
                            std::FILE* out);

}  // namespace caravan::experiment
