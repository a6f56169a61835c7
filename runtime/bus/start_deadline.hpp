// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace caravan::runtime {

/// While it lives, DDS is joining a domain. When that takes longer than 15 s the process says so and ends
/// with exit code 2: a port that a killed process left half-made hangs DDS for ever, and there is no way to
/// interrupt it.
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
