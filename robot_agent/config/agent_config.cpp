// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/agent_config.hpp"

#include <cmath>
#include <string>

#include "robot_agent/config/tables.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::agent {
namespace {

void take_robots(const runtime::RobotsTable& robots, Config& config) {
  config.task.source = {robots.source_m[0], robots.source_m[1]};
  config.task.destination = {robots.destination_m[0], robots.destination_m[1]};
  config.task.service_radius_m = robots.service_radius_m;
  config.body.wheel_limit_mps = robots.wheel_limit_mps;
  config.body.track_m = robots.track_m;
  config.body.wheel_radius_m = robots.wheel_radius_m;
  config.body.ahead_m = robots.body_ahead_m;
  config.body.length_m = robots.body_length_m;
  config.body.width_m = robots.body_width_m;
  config.sonars.aperture_rad = robots.sonar.aperture_rad;
  config.sonars.range_m = robots.sonar.range_m;
  config.robots_are_solid = robots.solid;
}

void check(const runtime::TomlTable& table, const Config& config) {
  if (config.driving.cruise_mps > config.body.wheel_limit_mps) {
    table.fail("cruise_mps",
               "must not exceed robots.wheel_limit_mps, " + std::to_string(config.body.wheel_limit_mps));
  }
  if (config.driving.slow_mps > config.driving.cruise_mps)
    table.fail("slow_mps", "must not exceed cruise_mps");
  if (config.driving.too_close_m > config.driving.slow_below_m) {
    table.fail("too_close_m", "must not exceed slow_below_m");
  }
  if (config.task.arrival_radius_m > config.task.service_radius_m) {
    table.fail("arrival_radius_m", "must not exceed robots.service_radius_m");
  }
  if (config.passage.corridor_m < config.body.width_m) {
    table.fail("corridor_m", "must not be less than robots.body_width_m");
  }
  if (config.surfaces.duration < config.surfaces.recent) {
    table.fail("surface_memory_s", "must not be less than surfaces.recent_s");
  }
}

}  // namespace

void read_time(TomlTable& table, const char* key, Time& value, double least_s) {
  double seconds = std::chrono::duration<double>(value).count();
  table.read(key, seconds, {least_s, runtime::kTime_s.high});
  value = Time{std::llround(seconds * 1e9)};
}

Config load_config(const runtime::TomlDocument& scenario, std::uint32_t robot) {
  const runtime::RobotsTable robots = runtime::read_robots(scenario);
  if (robot < 1 || robot > robots.count) {
    throw runtime::StartError{scenario.file() + ": --robot: must be 1 to " + std::to_string(robots.count) +
                              " (robots.count), is " + std::to_string(robot)};
  }
  Config config;
  config.id = RobotId{static_cast<std::uint16_t>(robot)};
  config.seed = runtime::read_seed(scenario);
  take_robots(robots, config);
  const runtime::RadioTable radio = runtime::read_radio(scenario);
  config.air.channel_count = radio.channel_count;
  config.air.mtu_bytes = radio.mtu_bytes;
  runtime::TomlTable table = scenario.table("algorithm");
  read_task(table, config);
  read_sensing(table, config);
  read_navigation(table, config);
  read_paths(table, config);
  read_radio_side(table, config);
  table.refuse_unknown();
  check(table, config);
  return config;
}

}  // namespace caravan::agent
