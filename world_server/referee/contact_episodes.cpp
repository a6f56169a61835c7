// SPDX-License-Identifier: Apache-2.0
#include "world_server/referee/contact_episodes.hpp"

namespace caravan::world {

std::vector<ContactEpisode> ContactEpisodes::begun(Time now, std::span<const ContactEpisode> touching) {
  std::vector<ContactEpisode> result;
  for (const ContactEpisode& pair : touching) {
    const auto [last, is_new] = last_touch_.try_emplace({pair.robot, pair.other}, now);
    if (is_new || now - last->second >= kApart) result.push_back(pair);
    last->second = now;
  }
  return result;
}

}  // namespace caravan::world
