// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace caravan::runtime {

/// From now on a controller that ends the process while it is called is named on stderr, in one line: after a
/// signal that a fault raises (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT), which then takes its course, and
/// when it calls exit(), which ends the process with `exit_code`, because that is no success. On every
/// thread, also when its stack is full.
///
/// Not caught are _exit(), quick_exit(), SIGKILL, and faults on threads of the controller's own.
void name_crashing_controllers(int exit_code);

/// While it lives, this thread is inside a controller.
class InsideController {
 public:
  /// @param who   "controller mine, robot 3"; must outlive this object
  /// @param step  0: its constructor
  /// @param now   simulated time of the step
  InsideController(const char* who, std::uint64_t step, std::chrono::nanoseconds now = {});
  ~InsideController();
  InsideController(const InsideController&) = delete;
  InsideController& operator=(const InsideController&) = delete;
};

}  // namespace caravan::runtime
