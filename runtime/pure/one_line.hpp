// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace caravan::pure {

/// Text that others wrote, such as a file's name or a key, as part of one line of a log: control characters,
/// line ends among them, become escapes, and what follows the first 1000 bytes is cut off.
[[nodiscard]] inline std::string one_line(std::string_view text) {
  constexpr std::size_t kLongest = 1000;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string line;
  for (const char one : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(one);
    if (one == '\n') {
      line += "\\n";
    } else if (byte < 0x20 || byte == 0x7f) {
      line += "\\x";
      line += kDigits[byte / 16];
      line += kDigits[byte % 16];
    } else {
      line += one;
    }
  }
  return text.size() > kLongest ? line + "..." : line;
}

}  // namespace caravan::pure
