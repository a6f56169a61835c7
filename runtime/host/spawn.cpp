// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/spawn.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// Closes every descriptor above standard error except `kept`, which is sorted: the child must not inherit
/// sockets of DDS and locks of the parent.
void keep_only(const std::vector<int>& kept) {
  unsigned first = STDERR_FILENO + 1;
  for (const int one : kept) {
    if (static_cast<unsigned>(one) > first) close_range(first, static_cast<unsigned>(one) - 1, 0);
    first = static_cast<unsigned>(one) + 1;
  }
  close_range(first, ~0U, 0);
}

/// Runs in the child between fork and exec: only system calls.
[[noreturn]] void become(const std::vector<char*>& arguments, int log, pid_t parent,
                         const SpawnOptions& options) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  signal(SIGINT, SIG_DFL);  // a shell starts background programs with SIGINT ignored
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, options.when_parent_dies);
  if (getppid() != parent) _exit(1);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  keep_only(options.shared);
  execv(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

pid_t spawn(std::vector<std::string> command_line, const std::filesystem::path& log, SpawnOptions options) {
  std::vector<char*> arguments;
  for (std::string& word : command_line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::sort(options.shared.begin(), options.shared.end());
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) throw StartError{log.string() + ": " + std::strerror(errno)};
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) become(arguments, file, parent, options);
  const int reason = errno;
  close(file);
  if (child < 0) throw StartError{"cannot start " + command_line[0] + ": " + std::strerror(reason)};
  return child;
}

}  // namespace caravan::runtime
