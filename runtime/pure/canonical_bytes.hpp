// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace caravan::pure {

/// Canonical byte order of the data in the digest (docs/digest.md): integers little-endian in 8 bytes, reals
/// as their IEEE 754 bits with -0 as +0 and every NaN as the one quiet NaN, byte strings preceded by their
/// length.
class CanonicalBytes {
 public:
  void word(std::uint64_t number) {
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + 8);
    for (std::size_t i = 0; i < 8; ++i) bytes_[begin + i] = static_cast<std::uint8_t>(number >> (8 * i));
  }
  void real(double number) {
    if (number == 0.0) number = 0.0;
    word(number != number ? 0x7ff8000000000000ULL : std::bit_cast<std::uint64_t>(number));
  }
  void bytes(std::span<const std::uint8_t> string) {
    word(string.size());
    bytes_.insert(bytes_.end(), string.begin(), string.end());
  }
  void clear() { bytes_.clear(); }
  [[nodiscard]] std::span<const std::uint8_t> view() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace caravan::pure
