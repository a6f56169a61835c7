// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <vector>

#include "experiment/metrics/observation.hpp"
#include "experiment/metrics/run_facts.hpp"
#include "radio_emulator/medium/medium.hpp"
#include "world_server/types.hpp"

/// Conversion between the values of the cores, as the topics do between processes. Byte strings are moved.
namespace caravan::experiment {

/// @param wheel_limit_mps  the world's limit: faster speeds are clamped to it, speeds that are not finite
/// become a stop
/// @param refusals  its counters are increased
[[nodiscard]] world::Command to_command(const caravan::Outputs& outputs, double wheel_limit_mps,
                                        Refusals& refusals);
/// Moves the frames out of `outputs`.
[[nodiscard]] radio::Transmission to_transmission(std::uint32_t robot, caravan::Outputs& outputs);
/// Moves the frames out of `reception`.
[[nodiscard]] std::vector<caravan::ReceivedFrame> to_heard(radio::Reception& reception);
[[nodiscard]] AgentReport to_report(std::uint32_t robot, const caravan::Report& report);

}  // namespace caravan::experiment
