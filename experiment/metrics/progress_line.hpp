// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// The text of one progress line.
///
/// @param speed  simulated over wall time
[[nodiscard]] std::string progress_text(const RunFacts& facts, const Progress& progress, double speed);

/// Shows how a run goes on: one line that is rewritten in place on a terminal, elsewhere a new line every
/// 5 s.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param out  null: shows nothing
  explicit ProgressLine(std::FILE* out);

  /// To be called as often as convenient: shows something when it is time.
  void update(const RunFacts& facts, const Progress& progress, Clock::time_point now);
  /// Leaves the terminal on a fresh line.
  void close();

 private:
  std::FILE* out_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point shown_;
  Time shown_stamp_{0};
};

}  // namespace caravan::experiment
