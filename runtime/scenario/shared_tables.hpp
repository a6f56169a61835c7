// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "runtime/config/toml_table.hpp"
#include "runtime/pure/propagation_config.hpp"
#include "runtime/pure/robot_model.hpp"

/// The scenario's tables that more than one process reads. A table that only one process reads is defined
/// beside that process.
namespace caravan::runtime {

struct SonarTable {
  std::uint32_t rays = 8;                                 ///< 1 .. 32 for each sonar
  double aperture_rad = robot_model::kSonarAperture_rad;  ///< full cone
  double range_m = robot_model::kSonarRange_m;
  double reflection_rad = 0.39269908169872414;  ///< 22.5 degrees: a ray that meets a surface at this angle or
                                                ///< more returns no echo
  double noise = 0.0;                           ///< relative standard deviation
};

/// `[robots]`: the fleet, its bodies and its task. Read by world server and agents.
struct RobotsTable {
  std::uint32_t count = 15;
  std::array<double, 2> source_m{};  ///< frame W
  std::array<double, 2> destination_m{};
  double service_radius_m = 1.5;  ///< radius in which items are picked up and delivered
  double wheel_limit_mps = robot_model::kWheelLimit_mps;  ///< rim speed
  double body_length_m = robot_model::kBodyLength_m;
  double body_ahead_m = robot_model::kBodyAhead_m;  ///< from the axle to the front
  double body_width_m = robot_model::kBodyWidth_m;
  double body_height_m = robot_model::kBodyHeight_m;
  double mass_kg = robot_model::kMass_kg;
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
  double gps_noise_m = 0.0;  ///< standard deviation of each coordinate
  double compass_noise_rad = 0.0;
  /// False: robots neither touch nor sense each other and ignore each other; only the radio connects them. No
  /// deployment is like that: it is for measuring the cost of traffic.
  bool solid = true;
  SonarTable sonar;  ///< `[robots.sonar]`
};

/// `[radio]`: the medium. Read by radio emulator and agents.
struct RadioTable {
  pure::PropagationConfig propagation;
  std::uint32_t channel_count = robot_model::kChannelCount;
  std::uint32_t mtu_bytes = robot_model::kMtu_bytes;
  std::uint32_t queue_length = 64;
};

enum class Pacing : std::uint8_t {
  kFast,      ///< lockstep, as fast as possible
  kRealtime,  ///< lockstep, in real time
  kFree       ///< real time, never waits
};
/// Reaction to a process that is alive but does not answer.
enum class OnHung : std::uint8_t {
  kWait,  ///< name it and wait
  kCoast  ///< go on without it until it answers again
};

/// `[experiment]`: the task and how the run is executed. Read by world server and launcher.
struct ExperimentTable {
  std::uint32_t items = 100;   ///< deliveries that end the run; 0: only `max_time_s` ends it
  double max_time_s = 7200.0;  ///< simulated
  Pacing pacing = Pacing::kFast;
  OnHung on_hung = OnHung::kWait;
  double start_timeout_s = 120.0;  ///< wall time that the start waits for all processes
};

[[nodiscard]] RobotsTable read_robots(const TomlDocument& scenario);
[[nodiscard]] RadioTable read_radio(const TomlDocument& scenario);
[[nodiscard]] ExperimentTable read_experiment(const TomlDocument& scenario);
/// The root key `seed`, read by every process.
[[nodiscard]] std::uint64_t read_seed(const TomlDocument& scenario);

}  // namespace caravan::runtime
