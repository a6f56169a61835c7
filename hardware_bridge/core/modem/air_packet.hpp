// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace caravan::bridge::modem {

using Bytes = std::vector<std::uint8_t>;

/// One frame as it goes between a program and its modem, or from modem to modem by UDP.
struct AirPacket {
  std::uint32_t from = 0;  ///< which modem; for telling one's own echo, never shown to an agent
  std::uint32_t channel = 0;
  Bytes payload;
  bool operator==(const AirPacket&) const = default;
};

/// 'C' 'V', version 1, the sender and the channel (both 4 bytes, little-endian), the payload, CRC-16 (CCITT,
/// 0xffff, big-endian).
[[nodiscard]] Bytes encode(const AirPacket& packet);
/// Empty when it is no such packet or a bit of it is wrong.
[[nodiscard]] std::optional<AirPacket> decode(std::span<const std::uint8_t> bytes);

/// SLIP (RFC 1055): packets on a stream. Each begins and ends with an END byte, so noise before it harms
/// nothing.
[[nodiscard]] Bytes to_slip(std::span<const std::uint8_t> packet);
class SlipReader {
 public:
  /// @return what lies between ENDs; never empty, never longer than 65535 bytes
  [[nodiscard]] std::vector<Bytes> feed(std::span<const std::uint8_t> bytes);

 private:
  Bytes held_;
  bool escaped_ = false;
  bool too_long_ = false;
};

}  // namespace caravan::bridge::modem
