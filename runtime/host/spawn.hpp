// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace caravan::runtime {

struct SpawnOptions {
  int when_parent_dies = SIGTERM;  ///< the signal that the child receives then
  std::vector<int> shared = {};    ///< descriptors that the child inherits; it gets no others
};

/// Starts a program as a child with no signal blocked or ignored, in its own process group: Ctrl-C at the
/// terminal reaches only the parent, which stops its children in order.
///
/// @param command_line  the first word is the program's path
/// @param log           receives its output and errors; an existing one is overwritten
/// @return its pid; the caller waits for its end
/// @throws StartError when the log cannot be written or no process can be created. A program that cannot be
///         executed ends with exit code 127.
[[nodiscard]] pid_t spawn(std::vector<std::string> command_line, const std::filesystem::path& log,
                          SpawnOptions options = {});

}  // namespace caravan::runtime
