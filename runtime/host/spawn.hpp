// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace caravan::runtime {

struct SpawnOptions {
  int when_parent_dies = SIGTERM;  ///< the signal that the child gets then
  std::vector<int> shared = {};    ///< descriptors that the child has too; it gets no others
};

/// Starts a program as a child with no signal blocked or ignored, in a process group of its own: Ctrl-C at
/// the terminal goes to the parent alone, which stops its children in order.
///
/// @param command_line  the first word is the program's path
/// @param log           receives its output and errors; an old one is overwritten
/// @return its pid; the caller waits for its end
/// @throws StartError when the log cannot be written or no process can be made. A program that cannot be
/// executed ends
///         with exit code 127.
[[nodiscard]] pid_t spawn(std::vector<std::string> command_line, const std::filesystem::path& log,
                          SpawnOptions options = {});

}  // namespace caravan::runtime
