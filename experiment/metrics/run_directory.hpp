// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// Creates the folder that a run writes to; never uses one with content.
///
/// @param wanted  the folder that the user asked for; it may exist if it is empty. Without it the folder is
///                runs/<scenario>-<mode>-<seed>-<yyyymmdd-hhmmss> (local time) in the working directory,
///                with -2, -3, ... if that exists.
/// @throws runtime::StartError
[[nodiscard]] std::filesystem::path make_run_directory(const std::optional<std::filesystem::path>& wanted,
                                                       const RunFacts& facts);

/// Replaces a file's text atomically: a reader sees the old or the new text, never a part.
/// @throws runtime::WriteError when it cannot be written; the old text stays
void write_whole_file(const std::filesystem::path& file, const std::string& text);

}  // namespace caravan::experiment
