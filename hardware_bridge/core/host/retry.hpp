// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// When a lost line is reopened: after half a second. If the other end repeatedly closes a connection within
/// 5 s, the wait doubles each time, up to 4 s: two hosts that take a device from each other leave it alone.
class Retry {
 public:
  [[nodiscard]] Time due() const { return due_; }
  /// An attempt starts.
  void tries(Time now) { due_ = now + wait_; }
  /// The line is up.
  void up(Time now) {
    if (!up_) up_ = now;
  }
  /// The line has ended. @param closed  by the other end
  void down(Time now, bool closed) {
    if (!up_) return;
    const bool brief = now - *up_ < kBrief;
    up_.reset();
    brief_ = closed && brief ? brief_ + 1 : 0;
    const unsigned doublings = std::min(brief_ == 0 ? 0U : brief_ - 1, 8U);
    wait_ = std::min(kLongest, kShortest * (1U << doublings));
    due_ = now + wait_;
  }
  /// This end closes the line, and reopens it at once.
  void again() {
    up_.reset();
    due_ = Time{0};
  }
  /// How many times in a row the other end closed the line soon after it came up.
  [[nodiscard]] unsigned brief() const { return brief_; }

 private:
  static constexpr Time kShortest = std::chrono::milliseconds{500};
  static constexpr Time kLongest = std::chrono::seconds{4};
  static constexpr Time kBrief = std::chrono::seconds{5};

  Time due_{0};
  Time wait_ = kShortest;
  std::optional<Time> up_;  // start of the connection
  unsigned brief_ = 0;
};

}  // namespace caravan::bridge
