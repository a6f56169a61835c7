// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <span>
#include <string>

namespace caravan::experiment {

/// How far a sweep is.
struct SweepCount {
  std::size_t total = 0;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t running = 0;
  std::optional<double> left_s;  ///< wall time, estimated; none: nothing is known yet
};

/// The wall time until the last run ends when each takes as long as the mean of those before.
///
/// @param mean_s   of the runs that have ended
/// @param waiting  runs that have not begun
/// @param ages_s   of those that are under way
/// @param jobs     runs at a time, >= 1
[[nodiscard]] double time_left_s(double mean_s, std::size_t waiting, std::span<const double> ages_s,
                                 std::size_t jobs);

/// `[#####...............] 23 of 90, 1 failed, 2 running, 12:40 left`
[[nodiscard]] std::string progress_bar(const SweepCount& count);

/// Shows how a sweep goes on: on a terminal a bar that is rewritten in place, and everywhere a line for each
/// run that ended.
class SweepProgress {
 public:
  /// @param out  null: shows nothing
  explicit SweepProgress(std::FILE* out);
  /// The bar; to be called as often as convenient.
  void show(const SweepCount& count);
  void say(const std::string& line);
  /// Leaves the terminal on a fresh line.
  void close();

 private:
  std::FILE* out_;
  bool terminal_;
  std::string shown_;
};

}  // namespace caravan::experiment
