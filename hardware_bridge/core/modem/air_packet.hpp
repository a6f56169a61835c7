// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace caravan::bridge::modem {

using Bytes = std::vector<std::uint8_t>;

/// A frame in transit between a program and its modem, or from modem to modem by UDP.
struct AirPacket {
  std::uint32_t from = 0;  ///< sending modem; identifies own echoes, not visible to agents
  std::uint32_t channel = 0;
  Bytes payload;
  bool operator==(const AirPacket&) const = default;
};

/// Layout: 'C' 'V', version 1, the sender and the channel (4 bytes each, little-endian), the payload, CRC-16
/// (CCITT, initial value 0xffff, big-endian).
[[nodiscard]] Bytes encode(const AirPacket& packet);
/// None when it is not such a packet, or its CRC is wrong.
[[nodiscard]] std::optional<AirPacket> decode(std::span<const std::uint8_t> bytes);

/// SLIP (RFC 1055): packets on a stream. Each starts and ends with an END byte, so noise before a packet does
/// not damage it.
[[nodiscard]] Bytes to_slip(std::span<const std::uint8_t> packet);
class SlipReader {
 public:
  /// @return the packets between END bytes; 1 to 65535 bytes each
  [[nodiscard]] std::vector<Bytes> feed(std::span<const std::uint8_t> bytes);

 private:
  Bytes held_;
  bool escaped_ = false;
  bool too_long_ = false;
};

}  // namespace caravan::bridge::modem
