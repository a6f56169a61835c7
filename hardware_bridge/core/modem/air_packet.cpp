// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/modem/air_packet.hpp"

#include <utility>

namespace caravan::bridge::modem {
namespace {

constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kHead = 11;
constexpr std::size_t kCheck = 2;

constexpr std::uint8_t kEnd = 0xc0;
constexpr std::uint8_t kEscape = 0xdb;
constexpr std::uint8_t kEscapedEnd = 0xdc;
constexpr std::uint8_t kEscapedEscape = 0xdd;
constexpr std::size_t kLongest = 65535;

unsigned crc16(std::span<const std::uint8_t> bytes) {
  unsigned crc = 0xffffU;
  for (const std::uint8_t byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8U;
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 0x8000U) != 0 ? ((crc << 1U) ^ 0x1021U) & 0xffffU : crc << 1U;
  }
  return crc;
}

void put(Bytes& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>((number >> shift) & 0xffU));
}

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= static_cast<std::uint32_t>(bytes[at + i]) << (8U * i);
  return number;
}

}  // namespace

Bytes encode(const AirPacket& packet) {
  Bytes bytes;
  bytes.reserve(kHead + packet.payload.size() + kCheck);
  bytes.push_back('C');
  bytes.push_back('V');
  bytes.push_back(kVersion);
  put(bytes, packet.from);
  put(bytes, packet.channel);
  bytes.insert(bytes.end(), packet.payload.begin(), packet.payload.end());
  const unsigned crc = crc16(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xffU));
  return bytes;
}

std::optional<AirPacket> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHead + kCheck || bytes[0] != 'C' || bytes[1] != 'V' || bytes[2] != kVersion)
    return std::nullopt;
  const auto checked = bytes.first(bytes.size() - kCheck);
  const unsigned told = static_cast<unsigned>(bytes[checked.size()] << 8U) | bytes[checked.size() + 1];
  if (crc16(checked) != told) return std::nullopt;
  const auto payload = checked.subspan(kHead);
  return AirPacket{number_at(bytes, 3), number_at(bytes, 7), {payload.begin(), payload.end()}};
}

Bytes to_slip(std::span<const std::uint8_t> packet) {
  Bytes bytes;
  bytes.push_back(kEnd);
  for (const std::uint8_t byte : packet) {
    if (byte == kEnd || byte == kEscape) bytes.push_back(kEscape);
    bytes.push_back(byte == kEnd ? kEscapedEnd : byte == kEscape ? kEscapedEscape : byte);
  }
  bytes.push_back(kEnd);
  return bytes;
}

std::vector<Bytes> SlipReader::feed(std::span<const std::uint8_t> bytes) {
  std::vector<Bytes> found;
  for (std::uint8_t byte : bytes) {
    if (byte == kEnd) {
      if (!held_.empty() && !too_long_) found.push_back(std::exchange(held_, {}));
      held_.clear();
      escaped_ = too_long_ = false;
      continue;
    }
    if (byte == kEscape && !escaped_) {
      escaped_ = true;
      continue;
    }
    if (std::exchange(escaped_, false)) {
      byte = byte == kEscapedEnd ? kEnd : byte == kEscapedEscape ? kEscape : byte;
    }
    too_long_ = too_long_ || held_.size() >= kLongest;
    if (!too_long_) held_.push_back(byte);
  }
  return found;
}

}  // namespace caravan::bridge::modem
