// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// True when the robot counts as being at the source or the destination: within config.task.arrival_radius_m;
/// or within config.task.service_radius_m while another robot, seen within 2.5 m ahead, keeps it from coming
/// nearer.
[[nodiscard]] bool has_arrived(const Perception& seen, const Point& at, const Config& config);

}  // namespace caravan::agent
