// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/config/bridge_table.hpp"

#include "runtime/scenario/shared_tables.hpp"

namespace caravan::bridge {
namespace {

using runtime::Range;

constexpr Range kAngle{-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
constexpr Range kShare{0.001, 1.0};
constexpr Range kTimeout_s{0.05, 60.0};

ArenaPlace place_of(const BridgeTable& table) {
  return {table.origin_latitude_deg, table.origin_longitude_deg, table.x_axis_rad};
}

FusionConfig fusion_of(const BridgeTable& table, bool has_gps) {
  FusionConfig fusion;
  fusion.has_gps = has_gps;
  fusion.has_compass = table.has_compass;
  fusion.start = {{table.start_m[0], table.start_m[1]}, wrapped(table.start_yaw_rad)};
  fusion.antenna_B = {table.antenna_m[0], table.antenna_m[1]};
  fusion.gps_trust = table.gps_trust;
  fusion.compass_trust = table.compass_trust;
  fusion.gps_timeout = to_time(table.gps_timeout_s);
  return fusion;
}

}  // namespace

BridgeTable read_bridge(const runtime::TomlDocument& scenario) {
  BridgeTable values;
  runtime::TomlTable table = scenario.table("bridge");
  table.read("origin_latitude_deg", values.origin_latitude_deg, {-89.0, 89.0});
  table.read("origin_longitude_deg", values.origin_longitude_deg, {-180.0, 180.0});
  table.read("x_axis_rad", values.x_axis_rad, kAngle);
  table.read("has_compass", values.has_compass);
  table.read("compass_offset_rad", values.compass_offset_rad, kAngle);
  table.read("antenna_m", values.antenna_m, {-2.0, 2.0});
  table.read("start_m", values.start_m, runtime::kPlace_m);
  table.read("start_yaw_rad", values.start_yaw_rad, kAngle);
  table.read("gps_trust", values.gps_trust, kShare);
  table.read("compass_trust", values.compass_trust, kShare);
  table.read("gps_timeout_s", values.gps_timeout_s, kTimeout_s);
  table.read("gps_jump_m", values.gps_jump_m, {0.1, 100.0});
  table.read("position_count_m", values.position_count_m, {0.0, 0.1});
  table.read("command_timeout_s", values.command_timeout_s, kTimeout_s);
  table.read("silence_s", values.silence_s, {0.15, 1.9});
  table.read("acceleration_mps2", values.acceleration_mps2, {0.05, 10.0});
  table.read("low_battery_v", values.low_battery_v, {1e-9, 100.0});
  table.read("has_gripper", values.has_gripper);
  table.read("watchdog_s", values.watchdog_s, kTimeout_s);
  table.refuse_unknown();
  return values;
}

BridgeConfig load_bridge_config(const runtime::TomlDocument& scenario, bool has_gps) {
  const BridgeTable table = read_bridge(scenario);
  const runtime::RobotsTable robots = runtime::read_robots(scenario);
  BridgeConfig config;
  config.link.acceleration_mps2 = table.acceleration_mps2;
  config.link.speed_limit_mps = robots.wheel_limit_mps;
  config.link.track_m = robots.track_m;
  config.link.silence = to_time(table.silence_s);
  config.link.slowest_watchdog = to_time(table.command_timeout_s);
  config.fusion = fusion_of(table, has_gps);
  config.arena = place_of(table);
  config.gps_jump_m = table.gps_jump_m;
  config.compass_offset_rad = table.compass_offset_rad;
  if (table.position_count_m > 0.0) config.position_count_m = table.position_count_m;
  config.command_timeout = to_time(table.command_timeout_s);
  config.low_battery_v = table.low_battery_v;
  config.has_gripper = table.has_gripper;
  config.source_W = {robots.source_m[0], robots.source_m[1]};
  config.service_radius_m = robots.service_radius_m;
  config.wheel_limit_mps = robots.wheel_limit_mps;
  config.track_m = robots.track_m;
  config.wheel_radius_m = robots.wheel_radius_m;
  return config;
}

RobotConfig load_robot_config(const runtime::TomlDocument& scenario, std::uint32_t robot) {
  const BridgeTable table = read_bridge(scenario);
  const runtime::RobotsTable robots = runtime::read_robots(scenario);
  if (robot < 1 || robot > robots.count) {
    throw runtime::StartError{scenario.file() + ": robot " + std::to_string(robot) +
                              " is not one of robots.count = " + std::to_string(robots.count)};
  }
  RobotConfig config;
  config.name = "caravan_" + std::to_string(robot);
  config.arena = place_of(table);
  config.compass_offset_rad = table.compass_offset_rad;
  config.antenna_B = {table.antenna_m[0], table.antenna_m[1]};
  config.track_m = robots.track_m;
  config.wheel_radius_m = robots.wheel_radius_m;
  config.watchdog = to_time(table.watchdog_s);
  return config;
}

}  // namespace caravan::bridge
