// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// One item of one robot: from picking it up to picking up the next.
struct Trip {
  std::uint32_t robot = 0;
  std::uint32_t number = 0;  ///< from 1 for each robot
  Time picked_up{0};
  std::optional<Time> delivered{};
  std::optional<Time> next_pick_up{};
};

/// Turns item events into trips.
class TripBook {
 public:
  /// @return the trip that the event ends: the robot's last one, when this is its next pick-up
  std::optional<Trip> add(Time stamp, const ItemEvent& event);
  /// The trips that no pick-up has ended yet, sorted by robot.
  [[nodiscard]] std::vector<Trip> open() const;

 private:
  std::map<std::uint32_t, Trip> open_;
};

}  // namespace caravan::experiment
