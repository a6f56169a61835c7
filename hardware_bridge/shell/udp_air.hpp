// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hardware_bridge/shell/descriptor.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

/// An air that all modems on this machine share: datagrams broadcast on the loopback network, which nothing
/// leaves.
class UdpAir {
 public:
  /// @throws StartError when the port cannot be had
  explicit UdpAir(std::uint16_t port);

  void send(std::span<const std::uint8_t> packet);
  /// The next datagram that waits, one's own too.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> receive();
  [[nodiscard]] runtime::Polled watched() const { return {hearing_.number(), false, false}; }

 private:
  std::uint16_t port_;
  Descriptor hearing_;
  Descriptor speaking_;
};

}  // namespace caravan::bridge
