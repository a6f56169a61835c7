// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace caravan::runtime {

using WallTime = std::chrono::steady_clock::time_point;

/// A descriptor that a wait watches beside its own.
struct Watched {
  int descriptor = -1;       ///< below 0: none, never ready
  bool for_writing = false;  ///< ready also when something can be written
  bool ready = false;        ///< after a wait: something can be read, or written, or it is broken
};

/// The main thread's one place to wait: for SIGINT or SIGTERM, for a wake-up by another thread, for a
/// deadline, or for descriptors.
///
/// Blocks the two signals for the whole process on construction, so make it before any other thread.
class Loop {
 public:
  enum class Woken : std::uint8_t { kStop, kNotified, kReady, kDeadline };

  Loop();
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// @param deadline none: as long as it takes
  /// @param others   whose `ready` is set, whatever the wait returns
  [[nodiscard]] Woken wait(std::optional<WallTime> deadline, std::span<Watched> others = {});
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
