// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace caravan::runtime {

void prepare_streams() {
  signal(SIGPIPE, SIG_IGN);
  // open() returns the lowest free number, so each call fills the first gap; the one beyond is closed again.
  int opened = -1;
  do {
    opened = open("/dev/null", O_RDWR);
  } while (opened >= 0 && opened <= STDERR_FILENO);
  if (opened > STDERR_FILENO) close(opened);
}

std::string failure_of_output() {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return "";
  const std::string reason = flushed ? "" : std::string{": "} + std::strerror(errno);
  pollfd output{STDOUT_FILENO, 0, 0};
  if (poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0) return "";
  return "standard output: not all that was printed could be written" + reason;
}

}  // namespace caravan::runtime
