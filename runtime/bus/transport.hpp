// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace caravan::runtime {

/// What a run's samples travel by; all of its processes must use the same. Neither leaves the machine.
enum class Transport : std::uint8_t {
  kSharedMemory,
  kUdp  ///< over 127.0.0.1, unicast; for machines without shared memory, and to compare
};

/// As it stands on a command line.
[[nodiscard]] constexpr const char* to_text(Transport transport) {
  return transport == Transport::kUdp ? "udp" : "shm";
}
/// @pre text is "shm" or "udp"
[[nodiscard]] constexpr Transport transport_named(std::string_view text) {
  return text == "udp" ? Transport::kUdp : Transport::kSharedMemory;
}

}  // namespace caravan::runtime
