// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/udp_air.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "runtime/config/start_error.hpp"

namespace caravan::bridge {
namespace {

sockaddr_in everybody_on(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = inet_addr("127.255.255.255");
  address.sin_port = htons(port);
  return address;
}

int udp_socket() { return socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0); }

}  // namespace

UdpAir::UdpAir(std::uint16_t port) : port_{port}, hearing_{udp_socket()}, speaking_{udp_socket()} {
  const int on = 1;
  setsockopt(hearing_.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  setsockopt(speaking_.number(), SOL_SOCKET, SO_BROADCAST, &on, sizeof on);
  sockaddr_in source{};
  source.sin_family = AF_INET;
  source.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const sockaddr_in address = everybody_on(port);
  if (bind(hearing_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      bind(speaking_.number(), reinterpret_cast<const sockaddr*>(&source), sizeof source) != 0) {
    throw runtime::StartError{"UDP port " + std::to_string(port) + ": " + std::strerror(errno)};
  }
}

void UdpAir::send(std::span<const std::uint8_t> packet) {
  const sockaddr_in address = everybody_on(port_);
  // Losses are intended, as on a real radio: no receiver, or a full buffer.
  (void)!sendto(speaking_.number(), packet.data(), packet.size(), 0,
                reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

std::optional<std::vector<std::uint8_t>> UdpAir::receive() {
  std::array<std::uint8_t, 65536> datagram{};
  const ssize_t count = recv(hearing_.number(), datagram.data(), datagram.size(), 0);
  if (count < 0) return std::nullopt;
  return std::vector<std::uint8_t>{datagram.begin(), datagram.begin() + count};
}

}  // namespace caravan::bridge
