// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/radio/frames/messages.hpp"
#include "robot_agent/core/sensing/settings.hpp"

namespace caravan::agent {

/// Another robot near by: its reported pose and twist, extrapolated to the present.
struct Neighbour {
  RobotId id;
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
  double speed_mps = 0.0;   ///< of its base, forward positive
  double turn_radps = 0.0;  ///< counter-clockwise positive
};

/// The pose and twist of a robot some time after its WAIT, if it keeps the reported twist.
[[nodiscard]] Neighbour carried_on(RobotId robot, const Whereabouts& told, Time after);

/// Stores the poses and twists reported in WAITs, and extrapolates them to the present.
class Neighbours {
 public:
  /// @param wait_period  longest time between two WAITs of a robot
  Neighbours(const NeighbourMemory& memory, Time wait_period);

  /// @param sent  time of the reported pose
  void hear(const Wait& wait, Time sent);
  /// Robots received recently, extrapolated by their reported twist, sorted by id.
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

/// What a robot reports of itself. None when its pose is unknown or too far from the origin for a frame.
[[nodiscard]] std::optional<Whereabouts> whereabouts_of(const Sensors& sensors, double speed_mps,
                                                        double turn_radps);

}  // namespace caravan::agent
