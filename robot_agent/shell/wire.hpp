// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl/robot_types.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// Between the agent's values and the wire. `stamp` and `session` of a sample are the caller's to set.
[[nodiscard]] Sensors to_core(const caravan_interfaces::msg::SensorFrame& frame);
[[nodiscard]] caravan_interfaces::msg::RobotCommand to_command(const Outputs& outputs);
/// Takes the frames' bytes out of `outputs`.
[[nodiscard]] caravan_interfaces::msg::RadioTransmit to_transmit(Outputs& outputs);
[[nodiscard]] caravan_interfaces::msg::Telemetry to_telemetry(const Report& report);

}  // namespace caravan::agent
