// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

/// Where the robot sees the destination; nothing when it does not.
///
/// Sight is simulated by distance, as in the paper (section 3.1): within
/// Exploration::detection_radius_m and not behind an obstacle that the sonars see. This is the only
/// place that reads Task::destination.
[[nodiscard]] std::optional<Point> sees_destination(const Perception& seen, const Task& task,
                                                    const Exploration& exploration, const Passage& passage);

}  // namespace caravan::agent
