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

void read_driving(runtime::TomlTable& table, Config& config) {
  table.read("exploration_step_m", config.exploration.step_m, kLength_m);
  table.read("exploration_spread_rad", config.exploration.spread_rad, kAngle);
  table.read("cruise_mps", config.driving.cruise_mps, kPositive);
  table.read("slow_mps", config.driving.slow_mps, kPositive);
  table.read("slow_below_m", config.driving.slow_below_m, kLength_m);
  table.read("too_close_m", config.driving.too_close_m, kLength_m);
  table.read("meeting_m", config.meeting.echo_m, kLength_m);
  table.read("keep_clear_m", config.keep_clear.robots_m, {0.0, kLength_m.high});
  table.read("arrival_radius_m", config.task.arrival_radius_m, kLength_m);
  table.read("touch_margin_m", config.obstacles.margin_m, {0.0, kLength_m.high});
  table.read("touched_places", config.obstacles.places, {0, 10000});
  read_time(table, "surface_memory_s", config.surfaces.duration, 20.0);
  read_time(table, "touch_patience_s", config.patience.timeout, 0.001);
  read_time(table, "gripper_patience_s", config.task.gripper_patience, 0.001);
}

void read_path(runtime::TomlTable& table, Config& config) {
  table.read("point_spacing_m", config.recording.spacing_m, {0.05, 100.0});
  table.read("vision_radius_m", config.smoothing.vision_radius_m, kLength_m);
  table.read("detection_radius_m", config.exploration.detection_radius_m, kLength_m);
  table.read("corridor_m", config.passage.corridor_m, kLength_m);
  table.read("shortcut_gain_m", config.smoothing.gain_m, kLength_m);
  read_time(table, "shortcut_pause_s", config.smoothing.pause);
}

void read_sharing(runtime::TomlTable& table, Config& config) {
  auto sharing = static_cast<std::size_t>(config.sharing.mode);
  table.read_choice("mode", sharing, {"none", "partial", "full"});
  config.sharing.mode = static_cast<Sharing>(sharing);
  table.read("stop_to_exchange", config.sharing.stop_to_exchange);
  read_time(table, "sharing_starts_s", config.sharing.starts);
  read_time(table, "recontact_after_s", config.sharing.recontact_after);
  read_time(table, "wait_period_s", config.wait.period);
  table.read("wait_tells_place", config.wait.tells_place);
  read_time(table, "accept_period_s", config.sharing.accept_period, 0.001);
  table.read("accept_attempts", config.sharing.accept_attempts, {1, 1000});
  read_time(table, "session_timer_s", config.sharing.session_timer, 0.001);
  table.read("points_per_frame", config.sharing.points_per_frame, {1, 65535});
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
  config.air.channel_count = radio.channel_count;
  config.air.mtu_bytes = radio.mtu_bytes;
  runtime::TomlTable table = scenario.table("algorithm");
  read_driving(table, config);
  read_path(table, config);
  read_sharing(table, config);
  table.refuse_unknown();
  check(table, config);
  return config;
}

}  // namespace caravan::agent
