// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {

void read_paths(TomlTable& algorithm, Config& config) {
  algorithm.read("point_spacing_m", config.recording.spacing_m, {0.05, 100.0});
  algorithm.read("vision_radius_m", config.smoothing.vision_radius_m, kLength_m);
  algorithm.read("shortcut_gain_m", config.smoothing.gain_m, kLength_m);
  read_time(algorithm, "shortcut_pause_s", config.smoothing.pause);
}

void read_task(TomlTable& algorithm, Config& config) {
  algorithm.read("arrival_radius_m", config.task.arrival_radius_m, kLength_m);
  read_time(algorithm, "gripper_patience_s", config.task.gripper_patience, 0.001);
}

}  // namespace caravan::agent
