// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <optional>
#include <string>

namespace caravan::bridge {

/// Address of a device on the command line: a serial port, or the same bytes over TCP.
struct PortAddress {
  std::string path;  ///< of a serial port; empty for TCP
  std::string host;
  std::string port;  ///< 1 to 65535
  bool operator==(const PortAddress&) const = default;
};
/// @param text  "/dev/ttyUSB0" or "tcp:HOST:PORT"
/// @throws StartError naming `option` when it is neither
[[nodiscard]] PortAddress parse_port(const std::string& text, const std::string& option);
[[nodiscard]] std::string to_text(const PortAddress& address);

/// A device that a Line can open.
struct Endpoint {
  PortAddress address;
  std::optional<sockaddr_in> place;  ///< of a TCP address
};
/// Resolves a host name once, so that a line never waits for the name service while wheels turn.
/// @throws StartError naming `option` when the host is unknown, or there is no answer within 5 s
[[nodiscard]] Endpoint resolve(const PortAddress& address, const std::string& option);

/// One text for all names of a device: a serial port without symbolic links, a TCP address in numbers.
[[nodiscard]] std::string canonical(const Endpoint& endpoint);

}  // namespace caravan::bridge
