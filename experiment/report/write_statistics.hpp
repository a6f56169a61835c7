// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// Adds the statistics to the tables of a sweep that has ended: summary.csv with estimates and intervals,
/// comparisons.csv, and, unless `quiet`, a table on standard output. docs/statistics.md describes them.
///
/// Without Python or SciPy it says so in one line on standard error; the tables of the sweep stay as they are
/// and an older comparisons.csv is removed, because it would not belong to them.
///
/// @param folder  of a sweep whose tables are written
/// @return whether a signal ended it
[[nodiscard]] bool write_statistics(const std::filesystem::path& folder, bool quiet, runtime::Loop& loop);

/// Removes comparisons.csv, of a sweep that was interrupted: it belongs to fewer runs than runs.csv.
void remove_comparisons(const std::filesystem::path& folder);

}  // namespace caravan::experiment
