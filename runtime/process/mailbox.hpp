// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "runtime/process/loop.hpp"

namespace caravan::runtime {

/// Mail from other threads to a process's main thread; posting wakes that thread.
template <typename Mail>
class Mailbox {
 public:
  explicit Mailbox(Loop& loop) : loop_{loop} {}

  void post(Mail mail) {
    {
      const std::lock_guard lock{mutex_};
      mail_.push_back(std::move(mail));
    }
    loop_.notify();
  }
  /// All mail since the last call, in order.
  [[nodiscard]] std::vector<Mail> take() {
    const std::lock_guard lock{mutex_};
    return std::exchange(mail_, {});
  }

 private:
  Loop& loop_;
  std::mutex mutex_;
  std::vector<Mail> mail_;
};

}  // namespace caravan::runtime
