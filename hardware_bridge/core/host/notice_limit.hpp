// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hardware_bridge/core/host/notice.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Limits how often notices of one kind are logged, so that an intermittent fault does not fill the log.
///
/// Events that differ only in their numbers are of one kind, and so are the states of one thing. The first
/// three of a kind pass. Of those that follow, the last one passes every 30 s, with their number. A state
/// also passes when it has lasted for 5 s: the last line of a log is the current state. A kind that was quiet
/// for 30 s starts anew.
class NoticeLimit {
 public:
  /// @return the notice if it is to be logged now
  [[nodiscard]] std::optional<Notice> pass(Notice notice, Time now);
  /// The held-back notices that are due.
  [[nodiscard]] std::vector<Notice> take_due(Time now);

 private:
  struct Kind {
    unsigned passed = 0;
    std::uint64_t held_back = 0;
    Notice last;
    Time changed{0};  // arrival of `last`
    Time due{0};      // when held-back notices pass, or the kind starts anew
  };
  std::map<std::string, Kind> kinds_;  // by the text without numbers
};

}  // namespace caravan::bridge
