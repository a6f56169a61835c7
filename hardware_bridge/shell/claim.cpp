// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/claim.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstddef>
#include <cstring>

#include "runtime/config/start_error.hpp"

namespace caravan::bridge {
namespace {

struct Name {
  sockaddr_un address{};
  socklen_t size = 0;
};

/// An abstract name starts with NUL. A name too long for it loses its beginning: the end is more distinctive.
Name name_of(const std::string& device) {
  std::string text = "caravan bridge ";
  const std::size_t room = sizeof(sockaddr_un::sun_path) - 1 - text.size();
  text += device.size() <= room ? device : device.substr(device.size() - room);
  Name name;
  name.address.sun_family = AF_UNIX;
  std::memcpy(name.address.sun_path + 1, text.data(), text.size());
  name.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + text.size());
  return name;
}

Descriptor new_socket() { return Descriptor{socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)}; }

/// The process that listens under the name; empty when it has just ended.
std::string holder_of(const Name& name) {
  const Descriptor asking = new_socket();
  const auto* address = reinterpret_cast<const sockaddr*>(&name.address);
  ucred holder{};
  socklen_t size = sizeof holder;
  if (connect(asking.number(), address, name.size) != 0 ||
      getsockopt(asking.number(), SOL_SOCKET, SO_PEERCRED, &holder, &size) != 0) {
    return "";
  }
  return " (pid " + std::to_string(holder.pid) + ", user " + std::to_string(holder.uid) + ")";
}

}  // namespace

Claim::Claim(const std::string& device, const std::string& option) : held_{new_socket()} {
  const Name name = name_of(device);
  const auto* address = reinterpret_cast<const sockaddr*>(&name.address);
  if (bind(held_.number(), address, name.size) == 0 && listen(held_.number(), 1) == 0) return;
  const int error = errno;
  throw runtime::StartError{option + ": " + device +
                            (error == EADDRINUSE
                                 ? " is in use by another bridge" + holder_of(name) + "; end that one first"
                                 : std::string{": "} + std::strerror(error))};
}

}  // namespace caravan::bridge
