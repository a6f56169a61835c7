// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace caravan::runtime {

/// The hash function SHA-256 (FIPS 180-4), over text that is added in parts.
class Sha256 {
 public:
  void add(std::string_view part);
  /// 64 hexadecimal digits, as `sha256sum` prints them. Call it once, after the last part.
  [[nodiscard]] std::string hex();

 private:
  void take_block();

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t length_ = 0;  // bytes
};

[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace caravan::runtime
