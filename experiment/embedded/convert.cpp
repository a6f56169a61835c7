// SPDX-License-Identifier: Apache-2.0
#include "experiment/embedded/convert.hpp"

#include <utility>

#include "world_server/referee/sanitise.hpp"

namespace caravan::experiment {
world::Command to_command(const caravan::Outputs& outputs, double wheel_limit_mps, Refusals& refusals) {
  const world::Sanitised safe = world::sanitise(outputs.left_mps, outputs.right_mps, wheel_limit_mps);
  refusals.commands_refused += safe.refused ? 1U : 0U;
  refusals.commands_clamped += safe.clamped ? 1U : 0U;
  return {.left_mps = safe.left_mps, .right_mps = safe.right_mps, .gripper_closed = outputs.gripper_closed};
}

radio::Transmission to_transmission(std::uint32_t robot, caravan::Outputs& outputs) {
  radio::Transmission transmission{.robot = robot, .tuned = outputs.tuned_channel, .frames = {}};
  transmission.frames.reserve(outputs.frames.size());
  for (caravan::Frame& frame : outputs.frames) {
    transmission.frames.push_back({.channel = frame.channel, .bytes = std::move(frame.bytes)});
  }
  return transmission;
}

std::vector<caravan::ReceivedFrame> to_heard(radio::Reception& reception) {
  std::vector<caravan::ReceivedFrame> heard;
  heard.reserve(reception.frames.size());
  for (radio::ReceivedFrame& frame : reception.frames) {
    heard.push_back({.channel = frame.channel,
                     .bytes = std::move(frame.bytes),
                     .signal_strength_dbm = frame.signal_strength_dbm});
  }
  return heard;
}

AgentReport to_report(std::uint32_t robot, const caravan::Report& report) {
  AgentReport result{.robot = robot,
                     .mode = report.mode,
                     .activity = report.activity,
                     .origin = report.origin,
                     .towards_destination = report.towards_destination,
                     .trips = report.trips,
                     .malformed_frames = report.malformed_frames,
                     .path_changed = report.path.has_value(),
                     .path = {},
                     .exchanges = report.exchanges,
                     .events = report.events};
  if (report.path) {
    for (const Position& point : *report.path) result.path.push_back({point.x_m, point.y_m});
  }
  return result;
}

}  // namespace caravan::experiment
