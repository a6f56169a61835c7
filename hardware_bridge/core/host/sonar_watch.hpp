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

/// Tells of sonars that cannot be right: transducers that read 0 for 2 s, and a robot whose sonars give no
/// readings for 3 s. A robot that believes them stands for no reason that anybody can see.
class SonarWatch {
 public:
  [[nodiscard]] std::vector<Notice> watch(std::span<const arcos::Sip::Sonar> readings, Time now);
  /// Another connection.
  void restart() { *this = {}; }

 private:
  using Set = std::bitset<kSonarCount>;
  [[nodiscard]] Set stuck(Time now) const;
  [[nodiscard]] Notice told_of(const Set& stuck) const;

  Set known_;                                                // transducers that were heard of
  std::array<std::optional<Time>, kSonarCount> zero_since_;  // none: the last reading was another
  Set told_;
  std::optional<Time> last_reading_;
  bool told_silent_ = false;
};

}  // namespace caravan::bridge
