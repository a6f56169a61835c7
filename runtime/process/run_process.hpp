// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/bus/transport.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::runtime {

/// Exit codes of every program.
enum ExitCode : int { kDone = 0, kFailed = 1, kCouldNotStart = 2, kConditionNotMet = 3, kInterrupted = 130 };

/// A numeric command line option of one program in addition to the common ones.
struct NumberOption {
  std::string flag;  ///< "--robot"
  std::string help;
  bool required = false;
  std::uint32_t* value = nullptr;
};

/// A text option that may be given several times.
struct TextOption {
  std::string flag;
  std::string help;
  std::vector<std::string>* values = nullptr;
};

struct Program {
  std::string name = {};
  std::string purpose = {};
  std::vector<NumberOption> numbers = {};
  std::vector<TextOption> texts = {};
};

/// The command line's values.
struct Start {
  std::filesystem::path scenario;
  std::uint32_t domain = 0;
  double lease_s = 5.0;  ///< --lease: silent for this long, this process counts as gone
  Transport transport = Transport::kSharedMemory;
  bool check_only = false;  ///< --check-config: read and check the configuration, then end
};

/// Thrown by a body that cannot continue in its state: the process closes its resources and executes itself
/// anew, with the same command line and process id.
struct BeginAnew {
  std::string reason;
};

/// Call this last in every main: what was printed is a result, too. Prints why not all of it was written.
/// @return `code`, or kFailed in place of kDone when it was not
[[nodiscard]] int with_output_written(int code);

/// The shell of every main: command line, logging to standard error, signals, exit codes.
///
/// A StartError becomes one line and exit code 2, a WriteError or any other exception one line and exit
/// code 1. With --check-config it prints `FILE: good` when the body has found nothing wrong.
int run_process(const Program& program, int argc, char** argv,
                const std::function<int(const Start&, Loop&)>& body);

}  // namespace caravan::runtime
