// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace caravan::pure {

/// FNV-1a over 64 bits, fed in canonical byte order: integers little-endian in 8 bytes, reals as their IEEE
/// 754 bits with -0 as +0 and every NaN as the one quiet NaN, byte strings with their length before them.
///
/// A chain's value after a step depends on everything fed to it since the start, so two runs with equal
/// values took equal steps.
class HashChain {
 public:
  constexpr void word(std::uint64_t number) {
    for (unsigned shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(number >> shift));
  }
  constexpr void real(double number) {
    if (number == 0.0) number = 0.0;
    word(number != number ? 0x7ff8000000000000ULL : std::bit_cast<std::uint64_t>(number));
  }
  constexpr void bytes(std::span<const std::uint8_t> string) {
    word(string.size());
    for (const std::uint8_t one : string) byte(one);
  }
  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

 private:
  constexpr void byte(std::uint8_t one) { value_ = (value_ ^ one) * 0x100000001b3ULL; }
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace caravan::pure
