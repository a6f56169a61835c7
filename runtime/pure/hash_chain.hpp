// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace caravan::pure {

/// FNV-1a over 64 bits (Fowler, Noll, Vo), from step to step.
///
/// A chain's value depends on every byte linked to it since the start, so two runs with equal values executed
/// equal steps.
class HashChain {
 public:
  /// @param step  in canonical byte order (CanonicalBytes)
  constexpr void link(std::span<const std::uint8_t> step) {
    for (const std::uint8_t byte : step) value_ = (value_ ^ byte) * 0x100000001b3ULL;
  }
  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace caravan::pure
