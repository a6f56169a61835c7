// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "deploy/cli/overrides.hpp"

namespace caravan::deploy {

struct CheckCommand {
  std::filesystem::path scenario;
};

struct RunCommand {
  std::filesystem::path scenario;
  bool embedded = false;  ///< which engine
  Overrides overrides;
  std::optional<std::uint32_t> domain;
  std::optional<std::filesystem::path> out;
  bool quiet = false;
};

/// Nothing is left to do: help or version was shown, or the command line was wrong and it was said why.
struct Exit {
  int code = 0;
};

/// What the command line of `caravan` asks for. Errors are one line on standard error and exit code 2.
[[nodiscard]] std::variant<CheckCommand, RunCommand, Exit> read_command_line(int argc,
                                                                             const char* const* argv);

}  // namespace caravan::deploy
