// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/refusals.hpp"

#include <algorithm>
#include <array>

namespace caravan::agent {
void Refusals::refuse(const Point& from, const Point& to, Time until) { pairs_.push_back({from, to, until}); }

void Refusals::touched(const Point& at, Time until) { places_.push_back({at, until}); }

void Refusals::forget(Time now) {
  std::erase_if(pairs_, [&](const Pair& pair) { return pair.until <= now; });
  std::erase_if(places_, [&](const Place& place) { return place.until <= now; });
}

bool Refusals::refuses(const Point& from, const Point& to, Time now) const {
  for (const Pair& pair : pairs_) {
    const bool same = are_alike(pair.from, from) && are_alike(pair.to, to);
    const bool reversed = are_alike(pair.from, to) && are_alike(pair.to, from);
    if (pair.until > now && (same || reversed)) return true;
  }
  const std::array<Point, 2> line = {from, to};
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return place.until > now && project(line, place.at).distance_m < touch_room_m_;
  });
}

}  // namespace caravan::agent
