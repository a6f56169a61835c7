// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "world_server/types.hpp"

namespace caravan::world {

/// Groups touches into episodes: those of one pair belong together until it has been apart for a second.
class ContactEpisodes {
 public:
  static constexpr Time kApart = std::chrono::seconds{1};

  /// @param now       must not decrease
  /// @param touching  the pairs that touch now, each once
  /// @return episodes that begin now, in the order of `touching`
  [[nodiscard]] std::vector<ContactEpisode> begun(Time now, std::span<const ContactEpisode> touching);

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, Time> last_touch_;
};

}  // namespace caravan::world
