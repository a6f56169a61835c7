// SPDX-License-Identifier: Apache-2.0
#include "runtime/scenario/shared_tables.hpp"

#include <numbers>

namespace caravan::runtime {
namespace {

// The range that the physics can step. ODE's solver fails on bodies outside it.
constexpr Range kBody_m{0.02, 20.0};
constexpr Range kWheel_m{0.005, 5.0};
constexpr Range kMass_kg{0.05, 10000.0};
constexpr Range kSpeed_mps{0.001, 100.0};

}  // namespace

RobotsTable read_robots(const TomlDocument& scenario) {
  RobotsTable robots;
  TomlTable table = scenario.table("robots");
  table.read("count", robots.count, {1, 10000});
  table.read("source_m", robots.source_m, kPlace_m);
  table.read("destination_m", robots.destination_m, kPlace_m);
  table.read("service_radius_m", robots.service_radius_m, kLength_m);
  table.read("wheel_limit_mps", robots.wheel_limit_mps, kSpeed_mps);
  table.read("body_length_m", robots.body_length_m, kBody_m);
  table.read("body_ahead_m", robots.body_ahead_m, kBody_m);
  table.read("body_width_m", robots.body_width_m, kBody_m);
  table.read("body_height_m", robots.body_height_m, kBody_m);
  table.read("mass_kg", robots.mass_kg, kMass_kg);
  table.read("track_m", robots.track_m, kBody_m);
  table.read("wheel_radius_m", robots.wheel_radius_m, kWheel_m);
  table.read("gps_noise_m", robots.gps_noise_m, {0.0, 1e6});
  table.read("compass_noise_rad", robots.compass_noise_rad, {0.0, 100.0});
  table.read("solid", robots.solid);
  TomlTable sonar = table.table("sonar");
  sonar.read("rays", robots.sonar.rays, {1, 32});
  sonar.read("aperture_rad", robots.sonar.aperture_rad, {0.0, std::numbers::pi / 2.0});
  sonar.read("range_m", robots.sonar.range_m, {0.01, 1000.0});
  sonar.read("reflection_rad", robots.sonar.reflection_rad, {0.0, std::numbers::pi / 2.0});
  sonar.read("noise", robots.sonar.noise, {0.0, 10.0});
  sonar.refuse_unknown();
  table.refuse_unknown();
  return robots;
}

RadioTable read_radio(const TomlDocument& scenario) {
  RadioTable radio;
  TomlTable table = scenario.table("radio");
  table.read("range_m", radio.propagation.range_m, kLength_m);
  table.read("channel_count", radio.channel_count, {2, 4294967295.0});
  table.read("mtu_bytes", radio.mtu_bytes, {32, 65535});
  table.read("queue_length", radio.queue_length, {1, 65535});
  table.read("loss_probability", radio.propagation.loss_probability, {0.0, 1.0});
  table.refuse_unknown();
  return radio;
}

ExperimentTable read_experiment(const TomlDocument& scenario) {
  ExperimentTable experiment;
  TomlTable table = scenario.table("experiment");
  table.read("items", experiment.items);
  table.read("max_time_s", experiment.max_time_s, kTime_s);
  std::size_t pacing = 0;
  table.read_choice("pacing", pacing, {"fast", "realtime", "free"});
  experiment.pacing = static_cast<Pacing>(pacing);
  std::size_t on_hung = 0;
  table.read_choice("on_hung", on_hung, {"wait", "coast"});
  experiment.on_hung = static_cast<OnHung>(on_hung);
  table.read("start_timeout_s", experiment.start_timeout_s, kTime_s);
  table.refuse_unknown();
  return experiment;
}

std::uint64_t read_seed(const TomlDocument& scenario) {
  std::uint64_t seed = 1;
  scenario.root().read("seed", seed);
  return seed;
}

}  // namespace caravan::runtime
