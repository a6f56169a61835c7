// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace caravan::runtime {

/// Counts the calls of controllers by one thread, for a watch on another.
class Calls {
 public:
  /// One call, from construction to destruction.
  class Call {
   public:
    explicit Call(Calls& calls) : calls_{calls} { calls_.count_.fetch_add(1, std::memory_order_release); }
    /// Does not return when the watch has given the call up: the watch is ending the process.
    ~Call() {
      std::uint64_t number = calls_.count_.load(std::memory_order_relaxed);
      if (is_given_up(number) || !calls_.count_.compare_exchange_strong(number, number + 1)) {
        for (;;) pause();
      }
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Calls& calls_;
  };

  /// Odd within a call; changes with every call and return.
  [[nodiscard]] std::uint64_t count() const { return count_.load(std::memory_order_acquire); }
  /// From here on the thread that called does nothing more. @return false: call `count` has returned
  [[nodiscard]] bool give_up(std::uint64_t count) {
    return count_.compare_exchange_strong(count, count | kGivenUp);
  }

 private:
  static constexpr std::uint64_t kGivenUp = std::uint64_t{1} << 63U;
  [[nodiscard]] static bool is_given_up(std::uint64_t count) { return (count & kGivenUp) != 0; }

  std::atomic<std::uint64_t> count_{0};
};

/// Whether the process has been told to stop by a signal that runtime::Loop has blocked and not yet taken.
[[nodiscard]] inline bool stop_is_pending() {
  sigset_t pending;
  sigpending(&pending);
  return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1 ||
         sigismember(&pending, SIGHUP) == 1;
}

/// Notices a controller that does not return, on a thread of its own.
class CallWatch {
 public:
  static constexpr std::chrono::seconds kLongestCall{10};
  enum class Reason : std::uint8_t {
    kTooLong,
    kStop  ///< the process has been told to stop, and the call goes on
  };

  /// @param give_up  is called on the watch's thread, once, with the number of the call (Calls::count()) that
  /// has been given up; must end the process
  CallWatch(Calls& calls, std::function<void(std::uint64_t call, Reason reason)> give_up)
      : thread_{[this, &calls, give_up = std::move(give_up)](const std::stop_token& stop) {
          watch(calls, give_up, stop);
        }} {}

 private:
  void watch(Calls& calls, const std::function<void(std::uint64_t, Reason)>& give_up,
             const std::stop_token& stop) {
    // Ticks and not a clock: a process that was stopped, by a debugger for instance, has lost no time.
    constexpr auto kTick = std::chrono::milliseconds{100};
    constexpr auto kLongEnoughToStop = 3 * kTick;  // shorter calls return to a loop that takes the signal
    std::chrono::milliseconds unchanged{0};
    std::uint64_t seen = 0;
    std::unique_lock lock{mutex_};
    const auto stopped = [&stop] { return stop.stop_requested(); };
    while (!ended_.wait_for(lock, stop, kTick, stopped)) {
      const std::uint64_t now = calls.count();
      unchanged = now == seen ? unchanged + kTick : kTick * 0;
      seen = now;
      if (now % 2 == 0) continue;
      const bool is_too_long = unchanged >= kLongestCall;
      const bool must_stop = unchanged >= kLongEnoughToStop && stop_is_pending();
      if ((is_too_long || must_stop) && calls.give_up(now))
        return give_up(now, must_stop ? Reason::kStop : Reason::kTooLong);
    }
  }

  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread thread_;  // the last member: it ends first
};

/// What is said of a call that the watch has given up. Follows the name of what was called.
[[nodiscard]] inline std::string to_text(CallWatch::Reason reason) {
  if (reason == CallWatch::Reason::kStop) return "has not returned, and this process is stopped";
  return "has not returned for " + std::to_string(CallWatch::kLongestCall.count()) + " s";
}

}  // namespace caravan::runtime
