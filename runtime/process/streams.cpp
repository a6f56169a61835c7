// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/streams.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace caravan::runtime {

void prepare_streams() {
  signal(SIGPIPE, SIG_IGN);
  // The lowest free number is given out, so each open fills the first gap; the one beyond is closed again.
  int opened = -1;
  do {
    opened = open("/dev/null", O_RDWR);
  } while (opened >= 0 && opened <= STDERR_FILENO);
  if (opened > STDERR_FILENO) close(opened);
}

}  // namespace caravan::runtime
