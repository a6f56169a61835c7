// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace caravan::experiment {

/// Wall time between laps.
class Stopwatch {
 public:
  /// Seconds since the last lap; the first time since construction.
  double lap_s() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> lap = now - last_;
    last_ = now;
    return lap.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace caravan::experiment
