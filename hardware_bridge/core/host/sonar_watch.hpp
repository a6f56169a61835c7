// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <span>
#include <vector>

#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/host/notice.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Reports implausible sonars: transducers that read 0 for 2 s, and a robot without sonar readings for 3 s.
/// Otherwise an agent that relies on them would stand without a visible reason.
class SonarWatch {
 public:
  [[nodiscard]] std::vector<Notice> watch(std::span<const arcos::Sip::Sonar> readings, Time now);
  /// A new connection.
  void restart() { *this = {}; }

 private:
  using Set = std::bitset<kSonarCount>;
  [[nodiscard]] Set stuck(Time now) const;
  [[nodiscard]] Notice told_of(const Set& stuck) const;

  Set known_;                                                // transducers that have ever given a reading
  std::array<std::optional<Time>, kSonarCount> zero_since_;  // none: the last reading was not 0
  Set told_;
  std::optional<Time> last_reading_;
  bool told_silent_ = false;
};

}  // namespace caravan::bridge
