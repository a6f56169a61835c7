// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// A program in experiment/report/, run by Debian's own interpreter, for which its libraries are installed.
struct PythonProgram {
  std::string caller;  ///< for messages: `caravan report`
  std::string file;    ///< its name
  std::vector<std::string> arguments;
  std::chrono::seconds patience;  ///< after this time it is ended
  /// Its stop ends the program and everything that it started; none: Ctrl-C reaches the program itself.
  runtime::Loop* loop = nullptr;
};

/// Starts it and waits for its end.
///
/// @return its exit code; kFailed when it was ended or crashed; kInterrupted when a signal ended it
/// @throws runtime::StartError when the program or the interpreter cannot be found or started
[[nodiscard]] int run_python(const PythonProgram& program);

}  // namespace caravan::experiment
