// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Detects a stalled wheel: far too slow for its command, for half a second.
class StallMonitor {
 public:
  void see(double told_mps, double is_mps, Time now) {
    constexpr double kAbove_mps = 0.05;
    constexpr double kBelow = 0.2;  // share of the command
    const double way = told_mps > 0.0 ? is_mps : -is_mps;
    if (std::abs(told_mps) <= kAbove_mps || way >= kBelow * std::abs(told_mps)) {
      slow_since_.reset();
    } else if (!slow_since_) {
      slow_since_ = now;
    }
  }
  [[nodiscard]] bool stalls(Time now) const {
    return slow_since_ && now - *slow_since_ >= std::chrono::milliseconds{500};
  }

 private:
  std::optional<Time> slow_since_;
};

}  // namespace caravan::bridge
