// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/robot/motion_control.hpp"

namespace caravan::bridge {

/// Changes the setting of an order, within the robot's limits.
/// @return false: the order does not set anything
[[nodiscard]] bool tune(arcos::Settings& settings, arcos::Order order, int value);

[[nodiscard]] MotionLimits limits_of(const arcos::Settings& settings);

}  // namespace caravan::bridge
