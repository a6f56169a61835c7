// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

/// docs/digest.md, implemented again: shares nothing with the code of the programs, so that page and programs
/// cannot diverge.
namespace caravan::test::documented {

inline void word(std::string& bytes, std::uint64_t value) {
  for (int i = 0; i < 8; ++i) {
    bytes.push_back(static_cast<char>(value % 256));
    value /= 256;
  }
}

inline void real(std::string& bytes, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, 8);
  if (bits == 0x8000000000000000ULL) bits = 0;
  const bool is_nan = (bits & 0x7fffffffffffffffULL) > 0x7ff0000000000000ULL;
  word(bytes, is_nan ? 0x7ff8000000000000ULL : bits);
}

/// FNV-1a of all data that the steps added.
inline std::uint64_t chain(const std::string& bytes) {
  std::uint64_t value = 0xcbf29ce484222325ULL;
  for (const char one : bytes) {
    value ^= static_cast<unsigned char>(one);
    value *= 0x100000001b3ULL;
  }
  return value;
}

inline std::uint64_t mix(std::uint64_t w) {
  w = (w ^ (w >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  w = (w ^ (w >> 27U)) * 0x94d049bb133111ebULL;
  return w ^ (w >> 31U);
}

inline std::string digest(std::uint64_t world, std::uint64_t radio) {
  const std::uint64_t g = 0x9e3779b97f4a7c15ULL;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx",
                static_cast<unsigned long long>(mix(mix(mix(g) + g + world) + g + radio)));
  return text;
}

/// The bytes of all whole steps in the text of a trace file.
inline std::string steps_in(const std::string& trace) {
  std::string steps;
  std::size_t at = trace.find('\n') + 1;
  while (at + 4 <= trace.size()) {
    std::size_t length = 0;
    for (int i = 3; i >= 0; --i)
      length = length * 256 + static_cast<unsigned char>(trace[at + static_cast<std::size_t>(i)]);
    at += 4;
    if (at + length > trace.size()) break;
    steps += trace.substr(at, length);
    at += length;
  }
  return steps;
}

}  // namespace caravan::test::documented
