// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "runtime/pure/random.hpp"

namespace caravan::pure {

/// The digest of a run: 16 hexadecimal digits of the world's and the radio's hash chains, both including the
/// deciding step. Equal digests mean that every command, pose, transmission and delivery was equal.
[[nodiscard]] inline std::string digest(std::uint64_t world_chain, std::uint64_t radio_chain) {
  constexpr const char* kDigits = "0123456789abcdef";
  const std::uint64_t both = mix_all(0, world_chain, radio_chain);
  std::string text;
  for (unsigned shift = 64; shift > 0;) {
    shift -= 4;
    text += kDigits[(both >> shift) & 0xfU];
  }
  return text;
}

}  // namespace caravan::pure
