// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace caravan::experiment {

/// Notices a controller that does not return from its step, on a thread of its own.
class StepWatch {
 public:
  static constexpr std::chrono::seconds kLongestStep{10};

  /// @param calls    odd while a controller is called; changes with every call and return
  /// @param give_up  is called on the watch's thread when a call has taken kLongestStep, with its number
  StepWatch(const std::atomic<std::uint64_t>& calls, std::function<void(std::uint64_t call)> give_up)
      : thread_{[this, &calls, give_up = std::move(give_up)](const std::stop_token& stop) {
          watch(calls, give_up, stop);
        }} {}

 private:
  void watch(const std::atomic<std::uint64_t>& calls, const std::function<void(std::uint64_t)>& give_up,
             const std::stop_token& stop) {
    // Ticks and not a clock: a process that was stopped, by a debugger for instance, has lost no time.
    constexpr auto kTick = std::chrono::milliseconds{500};
    std::chrono::milliseconds unchanged{0};
    std::uint64_t seen = 0;
    std::unique_lock lock{mutex_};
    const auto stopped = [&stop] { return stop.stop_requested(); };
    while (!ended_.wait_for(lock, stop, kTick, stopped)) {
      const std::uint64_t now = calls.load(std::memory_order_acquire);
      unchanged = now == seen ? unchanged + kTick : kTick * 0;
      seen = now;
      if (now % 2 == 1 && unchanged >= kLongestStep) return give_up(now);
    }
  }

  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread thread_;  // the last member: it ends first
};

}  // namespace caravan::experiment
