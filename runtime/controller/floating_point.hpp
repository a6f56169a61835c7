// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>

namespace caravan::runtime {

/// Undoes at its end what foreign code has changed in this thread's floating-point environment: rounding,
/// traps, flushing to zero. World and radio compute on the same thread.
class KeptFloatingPoint {
 public:
  KeptFloatingPoint() { (void)usual(); }
  ~KeptFloatingPoint() {
    if (control_ != control()) std::fesetenv(&usual());
  }
  KeptFloatingPoint(const KeptFloatingPoint&) = delete;
  KeptFloatingPoint& operator=(const KeptFloatingPoint&) = delete;

 private:
  /// What a change shows in: read in each step, while the whole environment is only restored after a change.
  static unsigned control() {
#ifdef __SSE2__
    constexpr unsigned kFlags = 0x3f;  // what has happened; decides nothing
    return __builtin_ia32_stmxcsr() & ~kFlags;
#else
    std::fenv_t now;
    std::fegetenv(&now);
    return now.__fpcr;  // of AArch64
#endif
  }
  /// The environment of the thread before it called any controller.
  static const std::fenv_t& usual() {
    static thread_local const std::fenv_t kept = [] {
      std::fenv_t now;
      std::fegetenv(&now);
      return now;
    }();
    return kept;
  }

  unsigned control_ = control();
};

}  // namespace caravan::runtime
