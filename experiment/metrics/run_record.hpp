// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/progress_line.hpp"
#include "experiment/metrics/record_files.hpp"
#include "experiment/metrics/run_facts.hpp"
#include "experiment/metrics/spare_room.hpp"

namespace caravan::experiment {

/// Processes the observations of an engine: metrics, the files of the run and the progress line.
///
/// All files exist from the beginning. They are flushed, and metrics.json and paths.csv are rewritten, once a
/// second of wall time, so that the death of the process loses nothing older. When the disk is full the
/// record ends: all rows up to then are whole, and metrics.json, for which space was reserved, gives the
/// reason.
class RunRecord {
 public:
  /// @param folder  exists and belongs to this run
  /// @param out     receives the progress; null: no progress
  /// @throws runtime::StartError when a file cannot be written
  RunRecord(RunFacts facts, std::filesystem::path folder, std::FILE* out);

  /// @pre stamps never decrease
  void observe(const Observation& observation);
  /// Call it at least once a second of wall time, however often: shows progress and flushes when due.
  /// @param so_far  what the engine knows so far; called only when something is due
  void keep_up(const std::function<RunEnd()>& so_far);
  /// False: a file can no longer be written, and the run should end.
  [[nodiscard]] bool is_whole() const { return failure_.empty(); }
  /// Writes the rest, reports on stderr if that failed, and prints the result table to stdout unless `out` is
  /// null.
  /// @return the exit code of the run
  int close(RunEnd end);

 private:
  void write_summary(const RunEnd& end, bool ended);
  /// Calls `write`, or keeps the reason of its failure. The first reason counts.
  void attempt(const std::function<void()>& write);

  RunFacts facts_;
  std::filesystem::path folder_;
  std::FILE* out_;
  Metrics metrics_;
  RecordFiles files_;
  SpareRoom spare_;
  std::string failure_;
  ProgressLine progress_;
  ProgressLine::Clock::time_point flushed_;
};

}  // namespace caravan::experiment
