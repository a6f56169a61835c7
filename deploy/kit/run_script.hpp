// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/bus/transport.hpp"
#include "runtime/config/setting.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// `caravan deploy`: one script.
struct ScriptRequest {
  std::filesystem::path script;
  std::optional<std::filesystem::path> out;    ///< for the logs; none: deployments/<script>-<time>
  std::optional<std::filesystem::path> junit;  ///< report file; none: junit.xml in the log folder
  std::string controller;                      ///< absolute path; empty: the scenario's
  runtime::Settings settings = {};             ///< of the scenario, after the script's changes; checked
  std::optional<std::uint32_t> domain;         ///< none: a free one
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  bool check_only = false;
  bool quiet = false;
};

/// Runs a script to its end or its first failure, and writes the report.
///
/// @return 0: all expectations were met, 3: one was not, 130: interrupted
/// @throws runtime::StartError when the script is invalid or nothing can be started, runtime::WriteError when
///         the report cannot be written
[[nodiscard]] int run_script(const ScriptRequest& request, runtime::Loop& loop);

/// The tables of actions and quantities, for --help.
[[nodiscard]] std::string script_help();

}  // namespace caravan::deploy
