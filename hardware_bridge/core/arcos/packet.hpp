// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace caravan::bridge::arcos {

using Bytes = std::vector<std::uint8_t>;

/// Data bytes of the longest packet that either side sends.
inline constexpr std::size_t kMostData = 202;

/// Sum of the big-endian 16-bit pairs, a last odd byte by exclusive or.
[[nodiscard]] std::uint16_t checksum(std::span<const std::uint8_t> data);

/// FA FB, the count, the data, the checksum. @pre 1 to kMostData bytes
[[nodiscard]] Bytes to_packet(std::span<const std::uint8_t> data);

/// Finds packets in a stream of bytes, whatever lies between them.
///
/// A packet with a wrong checksum or an impossible count is given up at its first byte only, so that a whole
/// packet behind a torn one is not lost with it. Never holds more than one packet's length.
class PacketFinder {
 public:
  /// @return the data of each packet that these bytes complete, in order
  [[nodiscard]] std::vector<Bytes> feed(std::span<const std::uint8_t> bytes);
  /// Forgets what is half received: the line is another one now.
  void restart() { held_.clear(); }

  [[nodiscard]] std::uint64_t bad_checksums() const { return bad_checksums_; }
  /// Bytes that belonged to no packet.
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
