// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace caravan {

/// SplitMix64's finaliser (Steele, Lea, Flood 2014): a bijection of 64-bit words whose output bits all depend
/// on all input bits.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t word) {
  word = (word ^ (word >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  word = (word ^ (word >> 27U)) * 0x94d049bb133111ebULL;
  return word ^ (word >> 31U);
}

/// One word from several; their order matters. For draws that belong to an event (step, sender, receiver)
/// rather than to a sequence, so that an additional event changes no other draw.
template <typename... Words>
[[nodiscard]] constexpr std::uint64_t mix_all(std::uint64_t seed, Words... words) {
  std::uint64_t state = mix(seed + 0x9e3779b97f4a7c15ULL);
  ((state = mix(state + 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(words))), ...);
  return state;
}

/// A word as a real number in [0, 1): the upper 53 bits times 2^-53.
[[nodiscard]] constexpr double unit_interval(std::uint64_t word) {
  return static_cast<double>(word >> 11U) * 0x1.0p-53;
}

/// A seeded stream of random numbers: SplitMix64. One stream for each device and robot, so that an additional
/// robot changes no other's draws.
///
/// The distributions are implemented here because those of the standard library differ between
/// implementations.
class Random {
 public:
  /// Streams of the same seed and different `stream` are independent.
  explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0) : state_{mix_all(seed, stream)} {}

  [[nodiscard]] constexpr std::uint64_t word() {
    state_ += 0x9e3779b97f4a7c15ULL;
    return mix(state_);
  }
  /// Uniform in [0, 1).
  [[nodiscard]] constexpr double unit() { return unit_interval(word()); }
  /// Uniform in [low, high).
  [[nodiscard]] constexpr double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// True with the given probability; always draws one word.
  [[nodiscard]] constexpr bool chance(double probability) { return unit() < probability; }
  /// Standard normal by Marsaglia's polar method; the second value of each pair is dropped so that the state
  /// is one word.
  [[nodiscard]] double normal() {
    for (;;) {
      const double u = uniform(-1.0, 1.0);
      const double v = uniform(-1.0, 1.0);
      const double s = u * u + v * v;
      if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * std::log(s) / s);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace caravan
