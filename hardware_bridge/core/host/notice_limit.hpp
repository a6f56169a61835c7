// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hardware_bridge/core/host/notice.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Limits how often notices of one kind are told, so that a fault that comes and goes does not fill a log.
///
/// Events that differ in their numbers only are of one kind, as are the states of one thing. The first three
/// of a kind pass. Of those that follow, the last one is told every 30 s, with how many there were; of states
/// also when it has lasted for 5 s, so that the last line of a log is the state that holds. A kind that was
/// quiet for 30 s begins anew.
class NoticeLimit {
 public:
  /// @return the notice, when it is to be told now
  [[nodiscard]] std::optional<Notice> pass(Notice notice, Time now);
  /// Those that were held back and are due.
  [[nodiscard]] std::vector<Notice> take_due(Time now);

 private:
  struct Kind {
    unsigned passed = 0;
    std::uint64_t held_back = 0;
    Notice last;
    Time changed{0};  // when `last` came
    Time due{0};      // what is held back is told, or the kind begins anew
  };
  std::map<std::string, Kind> kinds_;  // by the text without its numbers
};

}  // namespace caravan::bridge
