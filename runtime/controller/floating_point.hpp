// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>

namespace caravan::runtime {

/// Undoes at its end what foreign code has changed in this thread's floating-point environment: rounding,
/// traps, flushing to zero. World and radio compute on the same thread.
class KeptFloatingPoint {
 public:
  KeptFloatingPoint() { std::fegetenv(&before_); }
  ~KeptFloatingPoint() { std::fesetenv(&before_); }
  KeptFloatingPoint(const KeptFloatingPoint&) = delete;
  KeptFloatingPoint& operator=(const KeptFloatingPoint&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace caravan::runtime
