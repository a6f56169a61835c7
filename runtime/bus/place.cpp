// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/place.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// What the names of a domain's places begin with; the port's number follows.
std::string mark_of(std::uint32_t domain) { return "caravan/" + std::to_string(domain) + "/"; }

/// A local socket of this name, which is in no file system; -1 when somebody else has it.
int hold(const std::string& name) {
  const int held = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // after a NUL: abstract
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(held, reinterpret_cast<const sockaddr*>(&address), size) == 0) return held;
  const int why = errno;
  if (held >= 0) close(held);
  if (why != EADDRINUSE) throw StartError{std::string{"no local socket (AF_UNIX): "} + std::strerror(why)};
  return -1;
}

/// Ports of all places of the domain, by the kernel's list of local sockets; it writes @ for the NUL.
std::vector<std::uint32_t> ports_in_use(std::uint32_t domain) {
  const std::string mark = " @" + mark_of(domain);
  std::vector<std::uint32_t> ports;
  std::ifstream sockets{"/proc/net/unix"};
  for (std::string line; std::getline(sockets, line);) {
    const std::size_t found = line.find(mark);
    if (found == std::string::npos) continue;
    std::uint32_t port = 0;
    const char* const digits = line.data() + found + mark.size();
    if (std::from_chars(digits, line.data() + line.size(), port).ec == std::errc{}) ports.push_back(port);
  }
  return ports;
}

}  // namespace

Place::Place(std::uint32_t domain) : domain_{domain} {
  while (held_ < 0) {
    port_ = fresh_port(domain);
    held_ = hold(mark_of(domain) + std::to_string(port_));
  }
}

Place::~Place() { close(held_); }

void Place::settle(rtps::BuiltinAttributes& discovery, const rtps::GUID_t& own) const {
  discovery.metatrafficUnicastLocatorList.clear();
  discovery.metatrafficUnicastLocatorList.push_back(shared_memory_locator(port_, own));
  discovery.initialPeersList.clear();
  for (const std::uint32_t other : ports_in_use(domain_)) {
    if (other != port_) discovery.initialPeersList.push_back(shared_memory_locator(other, own));
  }
}

}  // namespace caravan::runtime
