// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

/// True when the robot has arrived at the source or the destination: within Task::arrival_radius_m, or within
/// Task::service_radius_m while another robot, seen within Task::crowded_m ahead, keeps it from coming
/// nearer.
[[nodiscard]] bool has_arrived(const Perception& seen, const Point& at, const Task& task, const Body& body);

}  // namespace caravan::agent
