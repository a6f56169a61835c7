// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "world_server/barrier/barrier.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The wall time at which the next step is due. A speed is simulated time divided by real time; 0: as fast as
/// possible.
class Pace {
 public:
  explicit Pace(Time period) : period_{period} {}

  /// The first step is due now.
  void start(Wall now) { due_ = now; }
  /// A step opens; the next one is due one period after this one was due. A delay of more than 100 ms is not
  /// made up for.
  void open(Wall now, double speed) {
    const Wall::duration period = period_at(speed);
    due_ = now - due_ > kLongDelay ? now + period : due_ + period;
  }
  /// The speed has changed, so the next step is due within one of its periods: it may have been due in
  /// minutes.
  void change(Wall now, double speed) { due_ = std::min(due_, now + period_at(speed)); }
  [[nodiscard]] Wall due() const { return due_; }
  [[nodiscard]] bool is_due(Wall now, double speed) const { return speed == 0.0 || now >= due_; }

 private:
  static constexpr std::chrono::milliseconds kLongDelay{100};

  [[nodiscard]] Wall::duration period_at(double speed) const {
    return std::chrono::duration_cast<Wall::duration>(std::chrono::duration<double, std::nano>(
        static_cast<double>(period_.count()) / (speed == 0.0 ? 1.0 : speed)));
  }

  Time period_;
  Wall due_{};
};

}  // namespace caravan::world
