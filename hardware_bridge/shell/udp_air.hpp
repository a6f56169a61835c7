// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hardware_bridge/shell/descriptor.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

/// The radio channel shared by all modems of this machine: datagrams broadcast on the loopback network, which
/// do not leave the machine.
class UdpAir {
 public:
  /// @throws StartError when the port is not available
  explicit UdpAir(std::uint16_t port);

  void send(std::span<const std::uint8_t> packet);
  /// The next pending datagram, own ones included.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> receive();
  [[nodiscard]] runtime::Polled watched() const { return {hearing_.number(), false, false}; }

 private:
  std::uint16_t port_;
  Descriptor hearing_;
  Descriptor speaking_;
};

}  // namespace caravan::bridge
