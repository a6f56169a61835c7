// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace caravan::experiment {

/// `caravan report`: starts the drawing program in experiment/report/, which writes the report of recorded
/// runs, and waits for it.
///
/// @param folders  folders of runs, or folders that contain some
/// @param out      target folder; none: report/ in the first folder
/// @return exit code: 0 written, 1 no run could be read, 2 the program or one of its dependencies is missing
/// @throws runtime::StartError when the program cannot be found or started
[[nodiscard]] int write_report(const std::vector<std::filesystem::path>& folders,
                               const std::optional<std::filesystem::path>& out);

}  // namespace caravan::experiment
