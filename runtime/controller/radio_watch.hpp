// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/robot.hpp>
#include <caravan/types.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Finds what the radio drops without a word to the controller.
class RadioWatch {
 public:
  enum class Kind : std::uint8_t { kLongFrame, kChannelOfFrame, kTunedChannel };
  /// What has been said already, by all controllers of a process.
  using Said = std::set<Kind>;

  /// @param said  not null
  RadioWatch(Radio limits, std::shared_ptr<Said> said) : limits_{limits}, said_{std::move(said)} {}

  /// A sentence for each kind that occurs for the first time; follows the name of the controller.
  [[nodiscard]] std::vector<std::string> look(const Outputs& outputs);

 private:
  void say(Kind kind, const std::string& text, std::vector<std::string>& all);

  Radio limits_;
  std::shared_ptr<Said> said_;
};

}  // namespace caravan::runtime
