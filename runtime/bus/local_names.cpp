// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/local_names.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {

int hold_local_name(const std::string& name) {
  const int held = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // after a NUL: an abstract name
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(held, reinterpret_cast<const sockaddr*>(&address), size) == 0) return held;
  const int why = errno;
  if (held >= 0) close(held);
  if (why != EADDRINUSE) throw StartError{std::string{"no local socket (AF_UNIX): "} + std::strerror(why)};
  return -1;
}

std::vector<std::string> local_names(const std::string& beginning) {
  const std::string mark = " @" + beginning;  // the kernel's list shows the NUL as @
  std::vector<std::string> names;
  std::ifstream sockets{"/proc/net/unix"};
  for (std::string line; std::getline(sockets, line);) {
    const std::size_t found = line.find(mark);
    if (found != std::string::npos) names.push_back(line.substr(found + mark.size()));
  }
  return names;
}

}  // namespace caravan::runtime
