// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge::arcos {

/// The last reading of each transducer and its time of arrival. A SIP contains only transducers that have
/// fired since the previous SIP.
class SonarMemory {
 public:
  void hear(std::span<const Sip::Sonar> readings, Time now) {
    for (const Sip::Sonar& reading : readings) {
      if (reading.index < kSonarCount) heard_[reading.index] = Heard{reading.range_mm, now};
    }
  }
  void forget() { heard_.fill(std::nullopt); }

  /// +inf: no echo; NaN: no reading yet.
  [[nodiscard]] std::array<double, kSonarCount> ranges_m() const {
    std::array<double, kSonarCount> ranges{};
    for (std::size_t i = 0; i < kSonarCount; ++i) {
      ranges[i] = !heard_[i]                          ? std::numeric_limits<double>::quiet_NaN()
                  : heard_[i]->range_mm >= kNoEcho_mm ? std::numeric_limits<double>::infinity()
                                                      : 0.001 * heard_[i]->range_mm;
    }
    return ranges;
  }
  /// Time since the reading arrived; +inf: no reading yet. The robot does not report when within the period
  /// of a SIP a transducer fired.
  [[nodiscard]] std::array<double, kSonarCount> ages_s(Time now) const {
    std::array<double, kSonarCount> ages{};
    for (std::size_t i = 0; i < kSonarCount; ++i) {
      ages[i] = heard_[i] ? seconds(now - heard_[i]->at) : std::numeric_limits<double>::infinity();
    }
    return ages;
  }

 private:
  struct Heard {
    std::uint16_t range_mm = 0;
    Time at{0};
  };
  std::array<std::optional<Heard>, kSonarCount> heard_;
};

}  // namespace caravan::bridge::arcos
