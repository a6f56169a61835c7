// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::test {

/// A wall, seen and solid from both sides.
struct Wall {
  agent::Point a, b;
};
/// The four sides of a rectangle turned about its centre.
[[nodiscard]] std::vector<Wall> rectangle(const agent::Point& centre, double width_m, double height_m,
                                          double yaw_rad = 0.0);

/// The sixteen ranges of a robot among walls. A ray that meets a wall at 22.5 degrees or more from its normal
/// is lost, as in the emulated world.
[[nodiscard]] std::array<double, agent::kSonarCount> sonar_ranges_m(std::span<const Wall> walls,
                                                                    const agent::Point& p_WB,
                                                                    double yaw_WB_rad, double range_m = 5.0);

/// What a robot, as it is by default, perceives among walls at time 0.
[[nodiscard]] agent::Perception look(std::span<const Wall> walls, const agent::Point& p_WB,
                                     double yaw_WB_rad);

}  // namespace caravan::test
