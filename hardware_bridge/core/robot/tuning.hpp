// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/robot/motion_control.hpp"

namespace caravan::bridge {

/// Changes the setting that an order is for, within what the robot can do.
/// @return false: the order is for none
[[nodiscard]] bool tune(arcos::Settings& settings, arcos::Order order, int value);

[[nodiscard]] MotionLimits limits_of(const arcos::Settings& settings);

}  // namespace caravan::bridge
