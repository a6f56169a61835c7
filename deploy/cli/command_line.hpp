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
  std::vector<std::string> sets;  ///< of --set, as in the other commands: input of read_settings()
};

struct NewCommand {
  std::string name;
};

struct RunCommand {
  std::filesystem::path scenario;
  bool embedded = false;  ///< engine embedded instead of dds
  Overrides overrides;
  std::vector<std::string> sets;
  std::optional<std::uint32_t> domain;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::string agent;  ///< program in the place of robot_agent; empty: none
  std::uint32_t agents_per_process = 1;
  std::optional<std::filesystem::path> out;
  bool trace = false;
  bool quiet = false;
  bool report = false;                         ///< draws a report at the end
  std::vector<std::string> command_line = {};  ///< all words, for the record
};

struct RerunCommand {
  std::filesystem::path run;
  std::optional<std::string> engine;  ///< none: that of the run
  std::optional<std::filesystem::path> out;
  bool quiet = false;
  std::vector<std::string> command_line = {};  ///< all words, for the record
};

struct ReportCommand {
  std::vector<std::filesystem::path> folders;
  std::optional<std::filesystem::path> out;
};

struct DiffCommand {
  std::filesystem::path one;
  std::filesystem::path other;
};

struct StepAgentCommand {
  std::filesystem::path run;
  std::uint32_t robot = 0;
  std::optional<std::string> controller;          ///< "paper" or a path; none: the scenario's
  std::optional<std::filesystem::path> scenario;  ///< none: the run's
  std::optional<std::uint64_t> step;              ///< from 1; none: the first that differs
};

struct SweepCommand {
  std::filesystem::path scenario;
  std::string engine = "embedded";
  std::string seeds = "1-10";        ///< a list of numbers
  std::optional<std::string> modes;  ///< input of read_modes(); none: see plan_sweep()
  Overrides overrides;               ///< for every run; neither mode nor seed
  std::vector<std::string> sets;     ///< axes: input of runtime::read_key_values()
  std::filesystem::path plan;        ///< input of read_plan(); empty: none
  std::size_t jobs = 1;              ///< without the option: one per processor
  std::filesystem::path out;
  std::optional<std::size_t> task;
  bool count = false;  ///< only print the number of runs
  bool summarise = false;
  bool retry_failed = false;
  bool quiet = false;
};

struct CtlCommand {
  std::uint32_t domain = 0;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::vector<std::string> words;  ///< input of run_ctl()
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
  std::string controller;  ///< "paper" or a path; empty: the scenario's
  std::vector<std::string> sets;
  std::optional<std::uint32_t> domain;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  bool check_only = false;
  bool quiet = false;
};

/// Nothing is left to do: help or version was printed, or the command line was wrong and the error was
/// printed.
struct Exit {
  int code = 0;
};

using Command =
    std::variant<CheckCommand, NewCommand, RunCommand, RerunCommand, DiffCommand, StepAgentCommand,
                 SweepCommand, ReportCommand, CtlCommand, DeployCommand, DoctorCommand, Exit>;

/// Reads the command line of `caravan`. An error is one line on standard error and exit code 2.
[[nodiscard]] Command read_command_line(int argc, const char* const* argv);

}  // namespace caravan::deploy
