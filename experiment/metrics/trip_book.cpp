// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/trip_book.hpp"

namespace caravan::experiment {

std::optional<Trip> TripBook::add(Time stamp, const ItemEvent& event) {
  const auto known = open_.find(event.robot);
  if (event.kind == ItemEvent::Kind::kDelivery) {
    if (known != open_.end() && !known->second.delivered) known->second.delivered = stamp;
    return std::nullopt;
  }
  if (known == open_.end()) {
    open_.emplace(event.robot, Trip{.robot = event.robot, .number = 1, .picked_up = stamp});
    return std::nullopt;
  }
  Trip ended = known->second;
  ended.next_pick_up = stamp;
  known->second = {.robot = event.robot, .number = ended.number + 1, .picked_up = stamp};
  return ended;
}

std::vector<Trip> TripBook::open() const {
  std::vector<Trip> trips;
  for (const auto& [robot, trip] : open_) trips.push_back(trip);
  return trips;
}

}  // namespace caravan::experiment
