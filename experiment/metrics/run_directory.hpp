// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// Makes the folder that a run writes to; never one that holds something already.
///
/// @param wanted  the folder that the user asked for; it may exist when it is empty. Without it the folder is
///                runs/<scenario>-<mode>-<seed>-<yyyymmdd-hhmmss> (local time) below the working directory,
///                with -2, -3, ... when that exists.
/// @throws runtime::StartError
[[nodiscard]] std::filesystem::path make_run_directory(const std::optional<std::filesystem::path>& wanted,
                                                       const RunFacts& facts);

/// The whole text as a file at once: a reader sees the old or the new text, never a part.
/// @throws runtime::WriteError when it cannot be written; the old text stays
void write_whole_file(const std::filesystem::path& file, const std::string& text);

}  // namespace caravan::experiment
