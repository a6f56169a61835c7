// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Estimates the lag of a line from the arrival of SIPs. The robot sends one SIP per cycle. If they arrive
/// more slowly, they wait in a queue on the way, and the host's data is older by that time.
///
/// A line that is too slow never delivers two SIPs within one cycle; a line that loses packets does. The time
/// per SIP is therefore the shortest of the last few gaps. The estimate decays by a twentieth of the elapsed
/// time: occasional losses do not add up, but a line that is slower by more than that does.
class LineLag {
 public:
  /// Handles a SIP. @param cycle  period of the robot's SIPs
  void arrived(Time now, Time cycle) {
    if (last_) {
      const Time passed = now - *last_;
      gaps_[next_++ % gaps_.size()] = passed;
      const Time takes = std::max(cycle, *std::min_element(gaps_.begin(), gaps_.end()));
      lag_ = std::clamp(lag_ + std::min(passed, takes) - cycle - passed / 20, Time{0}, kMost);
    }
    last_ = now;
  }
  /// Handles a corrupted packet: it has arrived.
  void destroyed(Time cycle) { lag_ = std::max(Time{0}, lag_ - cycle); }

  /// Handles an answer. @param since  time since its question, or an older one
  void answered(Time since) { lag_ = std::min(lag_, since); }

  [[nodiscard]] Time lag() const { return lag_; }

 private:
  static constexpr Time kMost = std::chrono::seconds{20};
  std::optional<Time> last_;
  std::array<Time, 4> gaps_{};  // between the last SIPs
  std::size_t next_ = 0;
  Time lag_{0};
};

}  // namespace caravan::bridge
