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

/// Everything that an engine does with its observations: metrics, the files of the run and the progress line.
///
/// Files are flushed and metrics.json and paths.csv are written anew once a second of wall time, so that the
/// death of the process loses nothing older. When the disk is full the record ends: the rows are whole until
/// then, and metrics.json, for which some room was kept, says why.
class RunRecord {
 public:
  /// @param folder  exists and is this run's own
  /// @param out     where progress goes; null: nowhere
  /// @throws runtime::StartError when a file cannot be written
  RunRecord(RunFacts facts, std::filesystem::path folder, std::FILE* out);

  /// @pre stamps never go back
  void observe(const Observation& observation);
  /// To be called at least once a second of wall time, however often: shows progress and flushes when due.
  /// @param so_far  what the engine knows by now; asked for only when something is due
  void keep_up(const std::function<RunEnd()>& so_far);
  /// False: a file could not be written any more, and the run should end.
  [[nodiscard]] bool is_whole() const { return failure_.empty(); }
  /// Writes what is left, says on stderr when that was not possible, and prints the result table to stdout
  /// unless `out` is null.
  /// @return the exit code of the run
  int close(RunEnd end);

 private:
  void write_summary(const RunEnd& end, bool ended);
  /// Does it, or keeps why not. The first reason counts.
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
