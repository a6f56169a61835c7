// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace caravan::runtime {

/// Guards the time in which DDS joins a domain. When that takes longer than 15 s the process reports it and
/// ends with exit code 2: a port that a killed process left half-made hangs DDS without end, and there is no
/// way to interrupt it.
class StartDeadline {
 public:
  explicit StartDeadline(std::uint32_t domain);
  ~StartDeadline();
  StartDeadline(const StartDeadline&) = delete;
  StartDeadline& operator=(const StartDeadline&) = delete;

 private:
  void watch(std::uint32_t domain);

  std::mutex mutex_;
  std::condition_variable changed_;
  bool joined_ = false;
  std::thread health_;
};

}  // namespace caravan::runtime
