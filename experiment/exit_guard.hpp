// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

namespace caravan::experiment {

/// While it lives, exit() ends the process with `code` and one line: a controller that calls it must not look
/// like a success. One at a time.
class ExitGuard {
 public:
  explicit ExitGuard(int code) {
    static const int registered = std::atexit(refuse_exit);
    code_ = registered == 0 ? code : 0;
  }
  ~ExitGuard() { code_ = 0; }
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;

 private:
  static void refuse_exit() {
    if (code_ == 0) return;
    std::fprintf(stderr, "a controller has called exit() in the middle of the run\n");
    std::_Exit(code_);
  }

  static inline int code_ = 0;  // 0: none lives
};

}  // namespace caravan::experiment
