// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/angle.hpp"
#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/neighbours.hpp"
#include "robot_agent/core/sensing/surroundings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// What one step's sensors and radio say, for the parts that drive. Position and heading are known.
struct Perception {
  Time now{0};
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
  bool holding = false;
  bool robot_near = false;  ///< a WAIT was heard just now
  Surroundings around;
  std::vector<Neighbour> robots;   ///< that told where they are, by id
  Surroundings still;              ///< `around` without the echoes of `robots`
  std::vector<Point> surfaces{};   ///< in W, near by: where something that is no robot was seen of late
  std::vector<Point> touched_W{};  ///< middles of what the robot touched and its sonars do not see, in W
  bool touched = false;            ///< ran into something just now that its sonars do not see

  /// Where a point of W lies as seen by the robot: 0 ahead, positive to the left.
  [[nodiscard]] double bearing_to(const Point& p_W) const {
    return wrapped(angle_of(p_W - p_WB) - yaw_WB_rad);
  }
  [[nodiscard]] double distance_to(const Point& p_W) const { return (p_W - p_WB).norm(); }
};

/// Puts one step's sensors and what was heard together. @pre position and heading are known
[[nodiscard]] Perception perceive(Time now, const Sensors& sensors, bool robot_near,
                                  std::vector<Neighbour> robots, const Sonars& sonars,
                                  const NeighbourMemory& memory, const Body& body);

}  // namespace caravan::agent
