// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/agent_config.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "runtime/scenario/shared_tables.hpp"

namespace caravan::agent {
namespace {

using runtime::kLength_m;
using runtime::kPositive;
using runtime::Range;

constexpr Range kAngle{1e-9, std::numbers::pi};

void read_time(runtime::TomlTable& table, const char* key, std::chrono::nanoseconds& value,
               double least_s = 0.0) {
  double seconds = std::chrono::duration<double>(value).count();
  table.read(key, seconds, {least_s, runtime::kTime_s.high});
  value = std::chrono::nanoseconds{std::llround(seconds * 1e9)};
}

void take_robots(const runtime::RobotsTable& robots, Config& config) {
  config.source = {robots.source_m[0], robots.source_m[1]};
  config.destination = {robots.destination_m[0], robots.destination_m[1]};
  config.service_radius_m = robots.service_radius_m;
  config.wheel_limit_mps = robots.wheel_limit_mps;
  config.track_m = robots.track_m;
  config.wheel_radius_m = robots.wheel_radius_m;
  config.body_ahead_m = robots.body_ahead_m;
  config.body_length_m = robots.body_length_m;
  config.body_width_m = robots.body_width_m;
  config.sonar_aperture_rad = robots.sonar.aperture_rad;
  config.sonar_range_m = robots.sonar.range_m;
  config.robots_are_solid = robots.solid;
}

void read_driving(runtime::TomlTable& table, Config& config) {
  table.read("exploration_step_m", config.exploration_step_m, kLength_m);
  table.read("exploration_spread_rad", config.exploration_spread_rad, kAngle);
  table.read("cruise_mps", config.cruise_mps, kPositive);
  table.read("slow_mps", config.slow_mps, kPositive);
  table.read("slow_below_m", config.slow_below_m, kLength_m);
  table.read("too_close_m", config.too_close_m, kLength_m);
  table.read("meeting_m", config.meeting_m, kLength_m);
  table.read("keep_clear_m", config.keep_clear_m, {0.0, kLength_m.high});
  table.read("arrival_radius_m", config.arrival_radius_m, kLength_m);
  table.read("touch_margin_m", config.touch_margin_m, {0.0, kLength_m.high});
  table.read("touched_places", config.touched_places, {0, 10000});
  read_time(table, "surface_memory_s", config.surface_memory, 20.0);
  read_time(table, "touch_patience_s", config.touch_patience, 0.001);
  read_time(table, "gripper_patience_s", config.gripper_patience, 0.001);
}

void read_path(runtime::TomlTable& table, Config& config) {
  table.read("point_spacing_m", config.point_spacing_m, {0.05, 100.0});
  table.read("vision_radius_m", config.vision_radius_m, kLength_m);
  table.read("detection_radius_m", config.detection_radius_m, kLength_m);
  table.read("corridor_m", config.corridor_m, kLength_m);
  table.read("shortcut_gain_m", config.shortcut_gain_m, kLength_m);
  read_time(table, "shortcut_pause_s", config.shortcut_pause);
}

void read_sharing(runtime::TomlTable& table, Config& config) {
  auto sharing = static_cast<std::size_t>(config.sharing);
  table.read_choice("mode", sharing, {"none", "partial", "full"});
  config.sharing = static_cast<Sharing>(sharing);
  table.read("stop_to_exchange", config.stop_to_exchange);
  read_time(table, "sharing_starts_s", config.sharing_starts);
  read_time(table, "recontact_after_s", config.recontact_after);
  read_time(table, "wait_period_s", config.wait_period);
  table.read("wait_tells_place", config.wait_tells_place);
  read_time(table, "accept_period_s", config.accept_period, 0.001);
  table.read("accept_attempts", config.accept_attempts, {1, 1000});
  read_time(table, "session_timer_s", config.session_timer, 0.001);
  table.read("points_per_frame", config.points_per_frame, {1, 65535});
}

void check(const runtime::TomlTable& table, const Config& config) {
  if (config.cruise_mps > config.wheel_limit_mps) {
    table.fail("cruise_mps",
               "must not exceed robots.wheel_limit_mps, " + std::to_string(config.wheel_limit_mps));
  }
  if (config.slow_mps > config.cruise_mps) table.fail("slow_mps", "must not exceed cruise_mps");
  if (config.too_close_m > config.slow_below_m) {
    table.fail("too_close_m", "must not exceed slow_below_m");
  }
  if (config.arrival_radius_m > config.service_radius_m) {
    table.fail("arrival_radius_m", "must not exceed robots.service_radius_m");
  }
  if (config.corridor_m < config.body_width_m) {
    table.fail("corridor_m", "must not be less than robots.body_width_m");
  }
}

}  // namespace

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
  config.channel_count = radio.channel_count;
  config.mtu_bytes = radio.mtu_bytes;
  runtime::TomlTable table = scenario.table("algorithm");
  read_driving(table, config);
  read_path(table, config);
  read_sharing(table, config);
  table.refuse_unknown();
  check(table, config);
  return config;
}

}  // namespace caravan::agent
