// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/radio/frames/messages.hpp"
#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// Another robot near by, where it is now as far as it told.
struct Neighbour {
  RobotId id;
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
  double speed_mps = 0.0;   ///< of its base, forward positive
  double turn_radps = 0.0;  ///< counter-clockwise positive
};

/// Where a robot is and how it moves, so long after it told so in a WAIT, if it moves on as it told.
[[nodiscard]] Neighbour carried_on(RobotId robot, const Whereabouts& told, Time after);

/// Remembers the whereabouts told in WAITs and carries them on to the present.
class Neighbours {
 public:
  /// @param wait_period  longest time between two WAITs of a robot
  Neighbours(const NeighbourMemory& memory, Time wait_period);

  /// @param sent when it was where it says
  void hear(const Wait& wait, Time sent);
  /// Those heard not long ago, moved on at the speed that they told, by id.
  [[nodiscard]] std::vector<Neighbour> now(Time now);

 private:
  struct Told {
    Neighbour neighbour;
    Time at;
  };
  Time remembers_;
  Time moves_on_;
  std::vector<Told> told_;  // by id
};

/// What a robot tells of itself. Positions beyond what the frame holds are not told.
[[nodiscard]] std::optional<Whereabouts> whereabouts_of(const Sensors& sensors, double speed_mps,
                                                        double turn_radps);

}  // namespace caravan::agent
