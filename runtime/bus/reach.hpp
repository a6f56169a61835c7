// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/bus/transport.hpp"

namespace caravan::runtime {

/// What a transport requires of the machine.
struct Reach {
  struct Server {
    std::string address;
    std::uint16_t port = 0;
    bool operator==(const Server&) const = default;
  };
  bool shared_memory = false;
  bool network = false;                 ///< UDP
  std::vector<std::string> interfaces;  ///< addresses that UDP is bound to; empty: all
  std::vector<Server> servers;          ///< Discovery Servers in use
};

/// @throws StartError when it is a profile that cannot be read
[[nodiscard]] Reach reach_of(const Transport& transport);

/// Version of the DDS library that the program was built with.
[[nodiscard]] std::string dds_version();
/// Prefix of the library's file name.
[[nodiscard]] std::string dds_library();

}  // namespace caravan::runtime
