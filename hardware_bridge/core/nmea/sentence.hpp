// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace caravan::bridge::nmea {

/// Longest accepted sentence. The standard says 82; receivers with more decimals exceed it.
inline constexpr std::size_t kLongest = 160;

/// GGA: fix data.
struct Gga {
  double time_of_day_s = 0.0;  ///< UTC
  double latitude_deg = 0.0;   ///< north positive
  double longitude_deg = 0.0;  ///< east positive
  unsigned quality = 0;        ///< 0: no fix; 6: estimated, 7: manual, 8: simulated
  unsigned satellites = 0;
  std::optional<double> hdop;
};

/// RMC: recommended minimum data.
struct Rmc {
  double time_of_day_s = 0.0;
  bool valid = false;
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double speed_mps = 0.0;
  std::optional<double> course_deg;  ///< clockwise from north
};

/// A valid sentence of another kind.
struct Other {};

/// Finds sentences in a stream of bytes: from "$" to the end of the line, with the right checksum.
class SentenceFinder {
 public:
  /// @return each sentence completed by these bytes, without "$", checksum and line end
  [[nodiscard]] std::vector<std::string> feed(std::span<const std::uint8_t> bytes);
  void restart() { line_.clear(); }
  /// Number of lines that were not a sentence, or had a wrong checksum.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  std::string line_;  // from "$" on; empty: between sentences
  std::uint64_t refused_ = 0;
};

/// @param sentence  as from SentenceFinder
/// @return none for an incomplete GGA or RMC, or one with a field out of range. A GGA without position has
/// quality 0.
[[nodiscard]] std::optional<std::variant<Gga, Rmc, Other>> parse(std::string_view sentence);

/// The sentence with "$GP", checksum and line end.
[[nodiscard]] std::string to_line(const Gga& gga);
[[nodiscard]] std::string to_line(const Rmc& rmc);

}  // namespace caravan::bridge::nmea
