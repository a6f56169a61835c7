// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <span>
#include <string>

namespace caravan::experiment {

/// The progress of a sweep.
struct SweepCount {
  std::size_t total = 0;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t running = 0;
  std::optional<double> left_s;  ///< estimated wall time; none: unknown
};

/// The wall time until the last run ends if each takes the mean time of those before.
///
/// @param mean_s   mean time of the runs that have ended
/// @param waiting  number of runs that have not begun
/// @param ages_s   times of the active runs so far
/// @param jobs     number of parallel runs, >= 1
[[nodiscard]] double time_left_s(double mean_s, std::size_t waiting, std::span<const double> ages_s,
                                 std::size_t jobs);

/// `[#####...............] 23 of 90, 1 failed, 2 running, 12:40 left`
[[nodiscard]] std::string progress_bar(const SweepCount& count);

/// Shows the progress of a sweep: on a terminal a bar that is rewritten in place, and always a line for each
/// run that ended.
class SweepProgress {
 public:
  /// @param out  null: shows nothing
  explicit SweepProgress(std::FILE* out);
  /// Draws the bar; call it as often as convenient.
  void show(const SweepCount& count);
  void say(const std::string& line);
  /// Ends the line on a terminal.
  void close();

 private:
  std::FILE* out_;
  bool terminal_;
  std::string shown_;
};

}  // namespace caravan::experiment
