// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/packet.hpp"

#include <algorithm>

#include "runtime/pure/assert.hpp"

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kFirst = 0xfa;
constexpr std::uint8_t kSecond = 0xfb;
constexpr std::size_t kHeader = 3;  // FA FB and the count
constexpr std::size_t kSumBytes = 2;

}  // namespace

std::uint16_t checksum(std::span<const std::uint8_t> data) {
  unsigned sum = 0;
  std::size_t at = 0;
  for (; at + 1 < data.size(); at += 2) sum += static_cast<unsigned>(data[at] << 8U) | data[at + 1];
  sum &= 0xffffU;
  if (at < data.size()) sum ^= data[at];
  return static_cast<std::uint16_t>(sum);
}

Bytes to_packet(std::span<const std::uint8_t> data) {
  CARAVAN_ASSERT(!data.empty() && data.size() <= kMostData);
  const std::uint16_t sum = checksum(data);
  Bytes packet;
  packet.reserve(kHeader + data.size() + kSumBytes);
  for (const std::size_t byte : {std::size_t{kFirst}, std::size_t{kSecond}, data.size() + kSumBytes}) {
    packet.push_back(static_cast<std::uint8_t>(byte));
  }
  packet.insert(packet.end(), data.begin(), data.end());
  packet.push_back(static_cast<std::uint8_t>(sum >> 8U));
  packet.push_back(static_cast<std::uint8_t>(sum & 0xffU));
  return packet;
}

std::vector<Bytes> PacketFinder::feed(std::span<const std::uint8_t> bytes) {
  std::vector<Bytes> found;
  for (const std::uint8_t byte : bytes) {
    held_.push_back(byte);
    while (advance(found)) {
    }
  }
  return found;
}

void PacketFinder::drop(std::size_t count) {
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(count));
}

bool PacketFinder::advance(std::vector<Bytes>& found) {
  const auto start = std::find(held_.begin(), held_.end(), kFirst);
  const auto before = static_cast<std::size_t>(start - held_.begin());
  stray_bytes_ += before;
  drop(before);
  if (held_.size() < 2) return false;
  const bool possible = held_[1] == kSecond && (held_.size() < kHeader ||
                                                (held_[2] > kSumBytes && held_[2] <= kMostData + kSumBytes));
  if (!possible) {
    ++stray_bytes_;
    drop(1);
    return true;
  }
  if (held_.size() < kHeader || held_.size() < kHeader + held_[2]) return false;
  const std::span<const std::uint8_t> data{held_.data() + kHeader, held_[2] - kSumBytes};
  const std::size_t end = kHeader + data.size();
  const unsigned told = static_cast<unsigned>(held_[end] << 8U) | held_[end + 1];
  if (told != checksum(data)) {
    ++bad_checksums_;
    ++stray_bytes_;
    drop(1);
    return true;
  }
  found.emplace_back(data.begin(), data.end());
  drop(end + kSumBytes);
  return true;
}

}  // namespace caravan::bridge::arcos
