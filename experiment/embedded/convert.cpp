// SPDX-License-Identifier: Apache-2.0
#include "experiment/embedded/convert.hpp"

#include <utility>

#include "world_server/referee/sanitise.hpp"

namespace caravan::experiment {
namespace {

Mode to_mode(agent::Mode mode) { return mode == agent::Mode::kTransport ? Mode::kTransport : Mode::kExplore; }

Activity to_activity(agent::Activity activity) {
  switch (activity) {
    case agent::Activity::kIdle:
      return Activity::kIdle;
    case agent::Activity::kDriving:
      return Activity::kDriving;
    case agent::Activity::kAvoiding:
      return Activity::kAvoiding;
    case agent::Activity::kExchanging:
      return Activity::kExchanging;
  }
  return Activity::kIdle;
}

Origin to_origin(agent::Origin origin) {
  switch (origin) {
    case agent::Origin::kNone:
      return Origin::kNone;
    case agent::Origin::kFound:
      return Origin::kFound;
    case agent::Origin::kReceived:
      return Origin::kReceived;
  }
  return Origin::kNone;
}

Exchange to_exchange(const agent::Exchange& exchange) {
  return {.partner = exchange.partner.value,
          .session = exchange.session,
          .primary = exchange.primary,
          .completed = exchange.completed,
          .began = exchange.began,
          .ended = exchange.ended};
}

}  // namespace

agent::Sensors to_sensors(const world::Senses& senses) {
  return {.sonar_range_m = senses.sonar_range_m,
          .sonar_age_s = senses.sonar_age_s,
          .p_WB = {senses.gps_x_m, senses.gps_y_m},
          .yaw_WB_rad = senses.compass_yaw_rad,
          .left_wheel_rad = senses.left_wheel_rad,
          .right_wheel_rad = senses.right_wheel_rad,
          .holding = senses.holding};
}

world::Command to_command(const agent::Outputs& outputs, double wheel_limit_mps, Refusals& refusals) {
  const world::Sanitised safe =
      world::sanitise(outputs.wheels.left_mps, outputs.wheels.right_mps, wheel_limit_mps);
  refusals.commands_refused += safe.refused ? 1U : 0U;
  refusals.commands_clamped += safe.clamped ? 1U : 0U;
  return {.left_mps = safe.left_mps, .right_mps = safe.right_mps, .gripper_closed = outputs.gripper_closed};
}

radio::Transmission to_transmission(std::uint32_t robot, agent::Outputs& outputs) {
  radio::Transmission transmission{.robot = robot, .tuned = outputs.tuned.value, .frames = {}};
  transmission.frames.reserve(outputs.frames.size());
  for (agent::Frame& frame : outputs.frames) {
    transmission.frames.push_back({.channel = frame.channel.value, .bytes = std::move(frame.bytes)});
  }
  return transmission;
}

std::vector<agent::ReceivedFrame> to_heard(radio::Reception& reception) {
  std::vector<agent::ReceivedFrame> heard;
  heard.reserve(reception.frames.size());
  for (radio::ReceivedFrame& frame : reception.frames) {
    heard.push_back({.channel = agent::Channel{frame.channel},
                     .bytes = std::move(frame.bytes),
                     .signal_strength_dbm = frame.signal_strength_dbm});
  }
  return heard;
}

AgentReport to_report(std::uint32_t robot, const agent::Report& report) {
  AgentReport result{.robot = robot,
                     .mode = to_mode(report.mode),
                     .activity = to_activity(report.activity),
                     .origin = to_origin(report.origin),
                     .towards_destination = report.towards_destination,
                     .trips = report.trips,
                     .malformed_frames = report.malformed_frames,
                     .path_changed = report.path_changed,
                     .path = {},
                     .exchanges = {},
                     .events = {}};
  if (report.path_changed) {
    for (const agent::Point& point : report.path) result.path.push_back({point.x(), point.y()});
  }
  for (const agent::Exchange& exchange : report.exchanges) result.exchanges.push_back(to_exchange(exchange));
  for (const agent::Event& event : report.events) result.events.push_back({event.name, event.detail});
  return result;
}

}  // namespace caravan::experiment
