// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace caravan::bridge::arcos {

using Bytes = std::vector<std::uint8_t>;

/// Largest number of data bytes in a packet, in either direction.
inline constexpr std::size_t kMostData = 202;

/// Sum of the big-endian 16-bit pairs; an odd last byte is combined by exclusive or.
[[nodiscard]] std::uint16_t checksum(std::span<const std::uint8_t> data);

/// FA FB, the count, the data, the checksum. @pre 1 to kMostData data bytes
[[nodiscard]] Bytes to_packet(std::span<const std::uint8_t> data);

/// Finds packets in a stream of bytes with noise in between.
///
/// After a wrong checksum or an impossible count only the first byte is dropped: a complete packet behind a
/// truncated one is found. Stores at most the length of one packet.
class PacketFinder {
 public:
  /// @return the data of each packet completed by these bytes, in order
  [[nodiscard]] std::vector<Bytes> feed(std::span<const std::uint8_t> bytes);
  /// Discards a partly received packet, for a new connection.
  void restart() { held_.clear(); }

  [[nodiscard]] std::uint64_t bad_checksums() const { return bad_checksums_; }
  /// Bytes outside of packets.
  [[nodiscard]] std::uint64_t stray_bytes() const { return stray_bytes_; }

 private:
  /// False: more bytes are needed.
  bool advance(std::vector<Bytes>& found);
  void drop(std::size_t count);

  Bytes held_;
  std::uint64_t bad_checksums_ = 0;
  std::uint64_t stray_bytes_ = 0;
};

}  // namespace caravan::bridge::arcos
