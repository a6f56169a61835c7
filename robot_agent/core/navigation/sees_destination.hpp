// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

/// The destination, if the robot sees it.
///
/// Sight is simulated by distance, as in the paper (section 3.1): within Exploration::detection_radius_m and
/// not hidden by an obstacle that the sonars see.
[[nodiscard]] std::optional<Point> sees_destination(const Perception& seen, const Task& task,
                                                    const Exploration& exploration, const Passage& passage);

}  // namespace caravan::agent
