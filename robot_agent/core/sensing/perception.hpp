// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/angle.hpp"
#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/neighbours.hpp"
#include "robot_agent/core/sensing/surroundings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// Sensors and radio of one step, prepared for planning and driving. Position and heading are known.
struct Perception {
  Time now{0};
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
  bool holding = false;
  bool robot_near = false;  ///< another robot was received recently
  Surroundings around;
  std::vector<Neighbour> robots;   ///< robots of known position, sorted by id
  Surroundings still;              ///< `around` without the echoes of `robots`
  std::vector<Point> surfaces{};   ///< near by, in W: where something that is not a robot was seen recently
  std::vector<Point> touched_W{};  ///< centres of touched obstacles that the sonars do not see, in W
  bool touched = false;            ///< has just run into something that the sonars do not see

  /// Bearing of a point of W: 0 ahead, positive to the left.
  [[nodiscard]] double bearing_to(const Point& p_W) const {
    return wrapped(angle_of(p_W - p_WB) - yaw_WB_rad);
  }
  [[nodiscard]] double distance_to(const Point& p_W) const { return (p_W - p_WB).norm(); }
};

/// Combines the sensors of one step with the radio. @pre position and heading are known
[[nodiscard]] Perception perceive(Time now, const Sensors& sensors, bool robot_near,
                                  std::vector<Neighbour> robots, const Sonars& sonars,
                                  const NeighbourMemory& memory, const Body& body);

}  // namespace caravan::agent
