// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace caravan::runtime {

using WallTime = std::chrono::steady_clock::time_point;

/// The main thread's one place to wait: for SIGINT or SIGTERM, for a wake-up by another thread, or for a
/// deadline.
///
/// Blocks the two signals for the whole process on construction, so make it before any other thread.
class Loop {
 public:
  enum class Woken : std::uint8_t { kStop, kNotified, kDeadline };

  Loop();
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// @param deadline none: as long as it takes
  [[nodiscard]] Woken wait(std::optional<WallTime> deadline);
  /// From any thread: the next or present wait returns kNotified.
  void notify();
  /// From any thread: every later wait returns kStop, as after a signal.
  void stop();
  /// Whether a signal (rather than stop()) ended the loop.
  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  int signals_ = -1;
  int wakeups_ = -1;
  int stops_ = -1;
  bool interrupted_ = false;
};

}  // namespace caravan::runtime
