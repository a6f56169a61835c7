// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/start_deadline.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

StartDeadline::StartDeadline(std::uint32_t domain) : health_{[this, domain] { watch(domain); }} {}

StartDeadline::~StartDeadline() {
  {
    const std::lock_guard lock{mutex_};
    joined_ = true;
  }
  changed_.notify_all();
  health_.join();
}

void StartDeadline::watch(std::uint32_t domain) {
  std::unique_lock lock{mutex_};
  if (changed_.wait_for(lock, std::chrono::seconds{15}, [this] { return joined_; })) return;
  std::fprintf(stderr,
               "DDS hangs while joining domain %u: a killed process has left a broken port there; remove "
               "/dev/shm/*%sport%u* to %u* or take another domain\n",
               domain, kSharedMemoryMark, 7400 + 250 * domain, 7649 + 250 * domain);
  std::_Exit(2);
}

}  // namespace caravan::runtime
