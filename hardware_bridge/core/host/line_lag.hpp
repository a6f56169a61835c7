// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// By how much a line is behind, as far as its SIPs show: the robot sends one each cycle, so what arrives
/// more slowly waits in a queue somewhere on the way, and what the host knows is so much older.
///
/// A line that is too slow never delivers two SIPs within a cycle, one that loses some does: what it takes
/// for a SIP is the shortest of the last few times between two. What is missing is forgotten by a twentieth
/// of the time that passes, so seldom losses do not add up, and a line that is slower by more than that does.
class LineLag {
 public:
  /// A SIP has arrived. @param cycle  of the robot
  void arrived(Time now, Time cycle) {
    if (last_) {
      const Time passed = now - *last_;
      gaps_[next_++ % gaps_.size()] = passed;
      const Time takes = std::max(cycle, *std::min_element(gaps_.begin(), gaps_.end()));
      lag_ = std::clamp(lag_ + std::min(passed, takes) - cycle - passed / 20, Time{0}, kMost);
    }
    last_ = now;
  }
  /// A packet was destroyed on the way: it did arrive.
  void destroyed(Time cycle) { lag_ = std::max(Time{0}, lag_ - cycle); }

  /// An answer has come. @param since  its question, or an older one
  void answered(Time since) { lag_ = std::min(lag_, since); }

  [[nodiscard]] Time lag() const { return lag_; }

 private:
  static constexpr Time kMost = std::chrono::seconds{20};
  std::optional<Time> last_;
  std::array<Time, 4> gaps_{};  // between SIPs, the last ones
  std::size_t next_ = 0;
  Time lag_{0};
};

}  // namespace caravan::bridge
