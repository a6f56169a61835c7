// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/listener.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "runtime/config/start_error.hpp"

namespace caravan::bridge {

Listener::Listener(std::uint16_t port)
    : descriptor_{socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)} {
  const int on = 1;
  setsockopt(descriptor_.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  socklen_t size = sizeof address;
  auto* name = reinterpret_cast<sockaddr*>(&address);
  if (bind(descriptor_.number(), name, size) != 0 || listen(descriptor_.number(), 4) != 0 ||
      getsockname(descriptor_.number(), name, &size) != 0) {
    throw runtime::StartError{"TCP port " + std::to_string(port) + ": " + std::strerror(errno)};
  }
  port_ = ntohs(address.sin_port);
}

std::optional<Listener::Accepted> Listener::accept() const {
  sockaddr_in peer{};
  socklen_t size = sizeof peer;
  Descriptor connection{
      accept4(descriptor_.number(), reinterpret_cast<sockaddr*>(&peer), &size, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  if (!connection.is_open()) return std::nullopt;
  return Accepted{std::move(connection), "127.0.0.1:" + std::to_string(ntohs(peer.sin_port))};
}

}  // namespace caravan::bridge
