// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>

#include "idl/robot_types.hpp"

namespace caravan::agent {

/// Conversion between a controller's values and samples. The caller sets `stamp` and `session` of a sample.
[[nodiscard]] caravan::Sensors to_sensors(const caravan_interfaces::msg::SensorFrame& frame);
[[nodiscard]] caravan_interfaces::msg::RobotCommand to_command(const caravan::Outputs& outputs);
/// Moves the frames' bytes out of `outputs`.
[[nodiscard]] caravan_interfaces::msg::RadioTransmit to_transmit(caravan::Outputs& outputs);
[[nodiscard]] caravan_interfaces::msg::Telemetry to_telemetry(const caravan::Report& report);

}  // namespace caravan::agent
