// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

namespace caravan::experiment {

// Values of steps as text that shows every difference.

/// The shortest text that reads back as the same number.
[[nodiscard]] inline std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}
[[nodiscard]] inline std::string text_of(std::uint64_t value) { return std::to_string(value); }
[[nodiscard]] inline std::string text_of(bool value) { return value ? "yes" : "no"; }
/// In hexadecimal.
[[nodiscard]] inline std::string text_of(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 0xfU];
  }
  return text.empty() ? "empty" : text;
}

}  // namespace caravan::experiment
