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
/// @param speed  simulated time divided by wall time
[[nodiscard]] std::string progress_text(const RunFacts& facts, const Progress& progress, double speed);

/// Shows the progress of a run: on a terminal one line that is rewritten in place, elsewhere a new line every
/// 5 s.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param out  null: shows nothing
  explicit ProgressLine(std::FILE* out);

  /// Call it as often as convenient: prints when a new line is due.
  void update(const RunFacts& facts, const Progress& progress, Clock::time_point now);
  /// Ends the line on a terminal.
  void close();

 private:
  std::FILE* out_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point shown_;
  Time shown_stamp_{0};
};

}  // namespace caravan::experiment
