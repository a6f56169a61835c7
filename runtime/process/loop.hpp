// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

namespace caravan::runtime {

using WallTime = std::chrono::steady_clock::time_point;

/// A further descriptor that a wait watches.
struct Polled {
  int descriptor = -1;       ///< below 0: none, never ready
  bool for_writing = false;  ///< ready also when it can be written
  bool ready = false;        ///< after a wait: it can be read, or written, or is broken
};

/// The only place where the main thread waits: for SIGINT, SIGTERM or SIGHUP, a wake-up by another thread, a
/// deadline, or descriptors.
///
/// It also notifies the service manager (see service_manager.hpp): ready at the first wait, alive whenever
/// the caller returns to wait, stopping on a stop.
///
/// Blocks the two signals, and SIGCONT, for the whole process on construction, so create it before any other
/// thread.
class Loop {
 public:
  enum class Woken : std::uint8_t { kStop, kNotified, kReady, kDeadline };

  Loop();
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// @param deadline none: waits without limit. May return kNotified earlier, so that the caller shows the
  ///                 service manager that it is alive
  /// @param others   their `ready` is set, whatever the wait returns
  [[nodiscard]] Woken wait(std::optional<WallTime> deadline, std::span<Polled> others = {});
  /// Whether, during the last wait, this process was stopped and continued (SIGSTOP, SIGCONT) and about its
  /// lease passed: the others may have dropped it. False for a process that is only slow. With waits of half
  /// a second the answer is accurate to half a second.
  [[nodiscard]] bool was_suspended_for(double lease_s) const {
    return continued_ && passed_ > std::chrono::duration<double>(0.9 * lease_s);
  }
  /// From any thread: the next or present wait returns kNotified.
  void notify();
  /// From any thread: every later wait returns kStop, as after a signal.
  void stop();
  /// Whether a signal (rather than stop()) ended the loop.
  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  Woken wait_until(std::optional<WallTime> deadline, std::span<Polled> others);

  int signals_ = -1;
  int wakeups_ = -1;
  int stops_ = -1;
  bool interrupted_ = false;
  bool continued_ = false;              // during the last wait
  std::chrono::nanoseconds passed_{0};  // during the last wait
  bool was_ready_ = false;
  std::optional<std::chrono::microseconds> watchdog_;  // how often the caller must return
  WallTime alive_due_{};
};

}  // namespace caravan::runtime
