// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/perception.hpp"

#include <algorithm>

namespace caravan::agent {
Perception perceive(Time now, const Sensors& sensors, bool robot_near, std::vector<Neighbour> robots,
                    const Sonars& sonars, const NeighbourMemory& memory, const Body& body) {
  const Surroundings around{sensors, sonars};
  const Point ahead = direction(sensors.yaw_WB_rad);
  const Surroundings still = around.without([&](const Point& p_B) {
    const Point p_W = sensors.p_WB + p_B.x() * ahead + p_B.y() * Point{-ahead.y(), ahead.x()};
    return std::ranges::any_of(robots, [&](const Neighbour& robot) {
      const double blur = memory.echo_m + memory.echo_per_metre * p_B.norm();
      return distance_m(Pose{robot.p_WB, robot.yaw_WB_rad}, p_W, body) < blur;
    });
  });
  return {now,        sensors.p_WB, sensors.yaw_WB_rad, sensors.holding,
          robot_near, around,       std::move(robots),  still,
          {}};
}

}  // namespace caravan::agent
