// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deploy/cli/overrides.hpp"
#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

struct CheckCommand {
  std::filesystem::path scenario;
};

struct RunCommand {
  std::filesystem::path scenario;
  bool embedded = false;  ///< which engine
  Overrides overrides;
  std::optional<std::uint32_t> domain;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::uint32_t agents_per_process = 1;
  std::optional<std::filesystem::path> out;
  bool trace = false;
  bool quiet = false;
  bool report = false;  ///< draw one at the end
};

struct ReportCommand {
  std::vector<std::filesystem::path> folders;
  std::optional<std::filesystem::path> out;
};

struct DiffCommand {
  std::filesystem::path one;
  std::filesystem::path other;
};

struct SweepCommand {
  std::filesystem::path scenario;
  std::string engine = "embedded";
  std::string seeds = "1-10";               ///< a list of numbers
  std::string modes = "none,partial,full";  ///< as read_modes() takes it
  Overrides overrides;                      ///< of every run; neither mode nor seed
  std::size_t jobs = 1;                     ///< without the option: one for each processor
  std::filesystem::path out;
  std::optional<std::size_t> task;
  bool count = false;  ///< only say how many runs there are
  bool summarise = false;
  bool retry_failed = false;
  bool quiet = false;
};

struct CtlCommand {
  std::uint32_t domain = 0;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::vector<std::string> words;  ///< as run_ctl() takes them
};

struct DoctorCommand {
  std::uint32_t robots = 15;
  std::uint32_t domain = 0;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  bool clean = false;
};

struct DeployCommand {
  std::filesystem::path script;
  std::optional<std::filesystem::path> out;
  std::optional<std::filesystem::path> junit;
  std::optional<std::uint32_t> domain;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  bool check_only = false;
  bool quiet = false;
};

/// Nothing is left to do: help or version was shown, or the command line was wrong and it was said why.
struct Exit {
  int code = 0;
};

using Command = std::variant<CheckCommand, RunCommand, DiffCommand, SweepCommand, ReportCommand, CtlCommand,
                             DeployCommand, DoctorCommand, Exit>;

/// What the command line of `caravan` asks for. Errors are one line on standard error and exit code 2.
[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

}  // namespace caravan::deploy
