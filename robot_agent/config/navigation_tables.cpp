// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {

void read_navigation(TomlTable& algorithm, Config& config) {
  algorithm.read("exploration_step_m", config.exploration.step_m, kLength_m);
  algorithm.read("exploration_spread_rad", config.exploration.spread_rad, kAngle_rad);
  algorithm.read("detection_radius_m", config.exploration.detection_radius_m, kLength_m);
  algorithm.read("cruise_mps", config.driving.cruise_mps, kPositive);
  algorithm.read("slow_mps", config.driving.slow_mps, kPositive);
  algorithm.read("slow_below_m", config.driving.slow_below_m, kLength_m);
  algorithm.read("too_close_m", config.driving.too_close_m, kLength_m);
  algorithm.read("meeting_m", config.meeting.echo_m, kLength_m);
  algorithm.read("keep_clear_m", config.keep_clear.robots_m, kDistance_m);
}

}  // namespace caravan::agent
