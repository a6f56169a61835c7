// SPDX-License-Identifier: Apache-2.0
#include "runtime/scenario/shared_tables.hpp"

#include <numbers>

namespace caravan::runtime {

RobotsTable read_robots(const TomlDocument& scenario) {
  RobotsTable robots;
  TomlTable table = scenario.table("robots");
  table.read("count", robots.count, {1, 10000});
  table.read("source_m", robots.source_m);
  table.read("destination_m", robots.destination_m);
  table.read("service_radius_m", robots.service_radius_m, kPositive);
  table.read("wheel_limit_mps", robots.wheel_limit_mps, kPositive);
  table.read("body_length_m", robots.body_length_m, kPositive);
  table.read("body_ahead_m", robots.body_ahead_m, kPositive);
  table.read("body_width_m", robots.body_width_m, kPositive);
  table.read("body_height_m", robots.body_height_m, kPositive);
  table.read("mass_kg", robots.mass_kg, kPositive);
  table.read("track_m", robots.track_m, kPositive);
  table.read("wheel_radius_m", robots.wheel_radius_m, kPositive);
  table.read("gps_noise_m", robots.gps_noise_m, kNotNegative);
  table.read("compass_noise_rad", robots.compass_noise_rad, kNotNegative);
  table.read("solid", robots.solid);
  TomlTable sonar = table.table("sonar");
  sonar.read("rays", robots.sonar.rays, {1, 32});
  sonar.read("aperture_rad", robots.sonar.aperture_rad, {0.0, std::numbers::pi / 2.0});
  sonar.read("range_m", robots.sonar.range_m, kPositive);
  sonar.read("reflection_rad", robots.sonar.reflection_rad, {0.0, std::numbers::pi / 2.0});
  sonar.read("noise", robots.sonar.noise, kNotNegative);
  sonar.refuse_unknown();
  table.refuse_unknown();
  return robots;
}

RadioTable read_radio(const TomlDocument& scenario) {
  RadioTable radio;
  TomlTable table = scenario.table("radio");
  table.read("range_m", radio.range_m, kPositive);
  table.read("channel_count", radio.channel_count, {2, 4294967295.0});
  table.read("mtu_bytes", radio.mtu_bytes, {32, 65535});
  table.read("queue_length", radio.queue_length, {1, 65535});
  table.read("loss_probability", radio.loss_probability, {0.0, 1.0});
  table.refuse_unknown();
  return radio;
}

ExperimentTable read_experiment(const TomlDocument& scenario) {
  ExperimentTable experiment;
  TomlTable table = scenario.table("experiment");
  table.read("items", experiment.items);
  table.read("max_time_s", experiment.max_time_s, kPositive);
  std::size_t pacing = 0;
  table.read_choice("pacing", pacing, {"fast", "realtime", "free"});
  experiment.pacing = static_cast<Pacing>(pacing);
  std::size_t on_hung = 0;
  table.read_choice("on_hung", on_hung, {"wait", "coast"});
  experiment.on_hung = static_cast<OnHung>(on_hung);
  table.read("start_timeout_s", experiment.start_timeout_s, kPositive);
  table.refuse_unknown();
  return experiment;
}

std::uint64_t read_seed(const TomlDocument& scenario) {
  std::uint64_t seed = 1;
  scenario.root().read("seed", seed);
  return seed;
}

}  // namespace caravan::runtime
