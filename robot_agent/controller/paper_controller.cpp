// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/controller/paper_controller.hpp"

#include <cmath>
#include <utility>

#include "robot_agent/core/navigation/sees_destination.hpp"

namespace caravan::agent {
namespace {

Sensors to_core(const caravan::Sensors& sensors) {
  return {.sonar_range_m = sensors.sonar_range_m,
          .sonar_age_s = sensors.sonar_age_s,
          .p_WB = {sensors.position.x_m, sensors.position.y_m},
          .yaw_WB_rad = sensors.yaw_rad,
          .left_wheel_rad = sensors.left_wheel_rad,
          .right_wheel_rad = sensors.right_wheel_rad,
          .holding = sensors.holding};
}

void to_core(const std::vector<caravan::ReceivedFrame>& heard, std::vector<ReceivedFrame>& core) {
  core.resize(heard.size());
  for (std::size_t i = 0; i < heard.size(); ++i) {
    core[i].channel = Channel{heard[i].channel};
    core[i].bytes = heard[i].bytes;
    core[i].signal_strength_dbm = heard[i].signal_strength_dbm;
  }
}

caravan::Report to_public(const Report& report) {
  caravan::Report result{.mode = report.mode,
                         .activity = report.activity,
                         .origin = report.origin,
                         .towards_destination = report.towards_destination,
                         .trips = report.trips,
                         .malformed_frames = report.malformed_frames,
                         .path = {},
                         .exchanges = {},
                         .events = {}};
  if (report.path_changed) {
    result.path.emplace();
    for (const Point& point : report.path) result.path->push_back({point.x(), point.y()});
  }
  for (const Exchange& exchange : report.exchanges) {
    result.exchanges.push_back({.partner = exchange.partner.value,
                                .session = exchange.session,
                                .primary = exchange.primary,
                                .completed = exchange.completed,
                                .began = exchange.began,
                                .ended = exchange.ended});
  }
  for (const Event& event : report.events) result.events.push_back({event.name, event.detail});
  return result;
}

}  // namespace

caravan::Outputs PaperController::step(const caravan::Inputs& inputs) {
  inputs_.now = inputs.now;
  inputs_.sensors = to_core(inputs.sensors);
  to_core(inputs.heard, inputs_.heard);
  Outputs decided = agent_.step(inputs_);
  caravan::Outputs outputs{.left_mps = decided.wheels.left_mps,
                           .right_mps = decided.wheels.right_mps,
                           .gripper_closed = decided.gripper_closed,
                           .tuned_channel = decided.tuned.value,
                           .frames = {},
                           .report = {}};
  outputs.frames.reserve(decided.frames.size());
  for (Frame& frame : decided.frames) outputs.frames.push_back({frame.channel.value, std::move(frame.bytes)});
  if (decided.reports) outputs.report = to_public(decided.report);
  return outputs;
}

Robot robot_of(const Config& config) {
  return {.id = config.id.value,
          .seed = config.seed,
          .body = {.length_m = config.body.length_m,
                   .ahead_m = config.body.ahead_m,
                   .width_m = config.body.width_m,
                   .track_m = config.body.track_m,
                   .wheel_radius_m = config.body.wheel_radius_m,
                   .wheel_limit_mps = config.body.wheel_limit_mps},
          .sonars = {.mounts = robot_model::kSonarMounts,
                     .aperture_rad = config.sonars.aperture_rad,
                     .range_m = config.sonars.range_m},
          .radio = {.channel_count = config.air.channel_count, .mtu_bytes = config.air.mtu_bytes},
          .source = {config.task.source.x(), config.task.source.y()},
          .service_radius_m = config.task.service_radius_m};
}

std::optional<Position> destination_in_sight(const caravan::Sensors& sensors, const Config& config) {
  const double away = std::hypot(sensors.position.x_m - config.task.destination.x(),
                                 sensors.position.y_m - config.task.destination.y());
  // Also false for an unknown position (NaN).
  const bool is_near = away <= config.exploration.detection_radius_m && std::isfinite(sensors.yaw_rad);
  if (!is_near) return std::nullopt;
  const Perception seen =
      perceive(Time{0}, to_core(sensors), false, {}, config.sonars, config.neighbours, config.body);
  const auto place = sees_destination(seen, config.task, config.exploration, config.passage);
  if (!place) return std::nullopt;
  return Position{place->x(), place->y()};
}

}  // namespace caravan::agent
