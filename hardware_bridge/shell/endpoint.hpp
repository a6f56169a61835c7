// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <optional>
#include <string>

namespace caravan::bridge {

/// Where a device is, as the command line names it: a serial port, or the same bytes over TCP.
struct PortAddress {
  std::string path;  ///< of a serial port; empty: TCP
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
/// Asks the name service for a host that is given by name, once: so a line never waits for it later, while
/// wheels turn.
/// @throws StartError naming `option` when the host is unknown or nothing is answered within 5 s
[[nodiscard]] Endpoint resolve(const PortAddress& address, const std::string& option);

/// The same for two names of one device: a serial port without symbolic links, a TCP address in numbers.
[[nodiscard]] std::string canonical(const Endpoint& endpoint);

}  // namespace caravan::bridge
