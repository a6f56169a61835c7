// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// By how much a line is behind, as far as its SIPs show: the robot sends one each cycle, so what arrives
/// more slowly waits in a queue somewhere on the way, and what the host knows is so much older.
///
/// A SIP that was lost looks the same, so what is missing is forgotten by a twentieth of the time that
/// passes: seldom losses do not add up, and a line that is slower by more than that does.
class LineLag {
 public:
  /// A SIP has arrived. @param cycle  of the robot
  void arrived(Time now, Time cycle) {
    if (last_) {
      const Time passed = now - *last_;
      lag_ = std::clamp(lag_ + passed - cycle - passed / 20, Time{0}, kMost);
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
  Time lag_{0};
};

}  // namespace caravan::bridge
