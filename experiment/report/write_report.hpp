// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace caravan::experiment {

/// `caravan report`: has the drawing program in experiment/report/ write the report of recorded runs and
/// waits for it.
///
/// @param folders  of runs, or folders that hold some
/// @param out      where to; none: report/ in the first folder
/// @return exit code: 0 written, 1 no run could be read, 2 the program or what it needs is missing
/// @throws runtime::StartError when the program cannot be found or started
[[nodiscard]] int write_report(const std::vector<std::filesystem::path>& folders,
                               const std::optional<std::filesystem::path>& out);

}  // namespace caravan::experiment
