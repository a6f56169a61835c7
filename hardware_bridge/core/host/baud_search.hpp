// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace caravan::bridge {

/// The order in which baud rates are tried on a serial line whose robot does not answer.
///
/// The rates are tried in turn, starting with 9600, the default of a Pioneer. After a robot has answered at a
/// rate, that rate is tried again first, and then at every second attempt: a robot that was away is found
/// within two attempts.
class BaudSearch {
 public:
  [[nodiscard]] unsigned rate() const { return answered_ && tries_answered_ ? *answered_ : kRates[at_]; }
  /// A robot answers at this rate.
  void found() {
    answered_ = rate();
    tries_answered_ = true;
    fresh_ = true;
  }
  /// No robot answers at this rate, or it no longer does.
  void next() {
    if (fresh_) {
      fresh_ = false;  // tries once more the rate at which the robot has just answered
      return;
    }
    if (answered_) tries_answered_ = !tries_answered_;
    if (!answered_ || !tries_answered_) at_ = (at_ + 1) % kRates.size();
  }

 private:
  static constexpr std::array kRates{9600U, 38400U, 19200U, 115200U, 57600U};
  std::size_t at_ = 0;
  std::optional<unsigned> answered_;
  bool tries_answered_ = false;
  bool fresh_ = false;  // the robot has answered since the line was opened
};

}  // namespace caravan::bridge
