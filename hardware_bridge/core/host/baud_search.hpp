// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace caravan::bridge {

/// Which rate is tried next on a serial line whose robot does not answer.
///
/// The rates go round, 9600 first: what a Pioneer is delivered with. Once a robot has answered at a rate,
/// that one comes first again, and then every second time: a robot that was away is found within two
/// attempts.
class BaudSearch {
 public:
  [[nodiscard]] unsigned rate() const { return answered_ && tries_answered_ ? *answered_ : kRates[at_]; }
  /// The robot answers at this rate.
  void found() {
    answered_ = rate();
    tries_answered_ = true;
    fresh_ = true;
  }
  /// It does not, or no longer.
  void next() {
    if (fresh_) {
      fresh_ = false;  // the rate at which it has just answered, once more
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
  bool fresh_ = false;  // it has answered since the line was opened
};

}  // namespace caravan::bridge
