// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {
namespace {

/// Limit of distances that cost computing time for each map cell, or each place, in every step.
constexpr Range kNear_m{0.0, 10.0};

void read_sonars(TomlTable table, Sonars& sonars) {
  table.read("longest_age_s", sonars.longest_age_s, runtime::kTime_s);
  table.refuse_unknown();
}

void read_passage(TomlTable table, Passage& passage) {
  table.read("surface_m", passage.surface_m, kDistance_m);
  table.read("surface_per_metre", passage.surface_per_metre, kPerMetre);
  table.refuse_unknown();
}

void read_neighbours(TomlTable table, NeighbourMemory& memory) {
  read_time(table, "presence_s", memory.presence);
  read_time(table, "duration_s", memory.duration);
  read_time(table, "extrapolation_s", memory.extrapolation);
  table.read("echo_m", memory.echo_m, kDistance_m);
  table.read("echo_per_metre", memory.echo_per_metre, kPerMetre);
  table.refuse_unknown();
}

void read_surfaces(TomlTable table, SurfaceMemory& memory) {
  read_time(table, "recent_s", memory.recent);
  table.read("recent_m", memory.recent_m, kDistance_m);
  table.read("exact_range_m", memory.exact_range_m, kDistance_m);
  table.read("same_place_m", memory.same_place_m, kDistance_m);
  table.read("reach_m", memory.reach_m, kNear_m);
  table.read("robot_radius_m", memory.robot_radius_m, kNear_m);
  table.read("touched_ahead_m", memory.touched_ahead_m, kDistance_m);
  table.read("wall_shortest_m", memory.wall_shortest_m, kLength_m);
  table.read("wall_longest_m", memory.wall_longest_m, kDistance_m);
  read_time(table, "wall_time_s", memory.wall_time);
  table.read("wall_cosine", memory.wall_cosine, kShare);
  table.read("wall_extension_m", memory.wall_extension_m, kDistance_m);
  table.read("cell_m", memory.cell_m, {0.01, 1.0});
  table.read("high_range_m", memory.high_range_m, kDistance_m);
  table.read("high_radius_m", memory.high_radius_m, kNear_m);
  table.refuse_unknown();
}

void read_obstacles(TomlTable table, ObstacleMemory& memory) {
  table.read("same_place_m", memory.same_place_m, kDistance_m);
  table.read("overlap_m", memory.overlap_m, kDistance_m);
  table.read("robot_m", memory.robot_m, kDistance_m);
  table.read("check_radius_m", memory.check_radius_m, kDistance_m);
  table.refuse_unknown();
}

void read_touch(TomlTable table, TouchSensing& touch) {
  table.read("reached_share", touch.reached_share, kShare);
  table.read("lost_share", touch.lost_share, kShare);
  table.read("slowest_mps", touch.slowest_mps, kSpeed_mps);
  table.read("pushed_mps", touch.pushed_mps, kSpeed_mps);
  read_time(table, "longest_gap_s", touch.longest_gap);
  read_time(table, "pause_s", touch.pause);
  table.refuse_unknown();
}

void read_vanishing_echo(TomlTable table, EchoLoss& echo) {
  table.read("seen_m", echo.seen_m, kDistance_m);
  table.read("one_thing_m", echo.one_thing_m, kDistance_m);
  table.read("nearest_m", echo.nearest_m, kDistance_m);
  table.read("farthest_m", echo.farthest_m, kDistance_m);
  table.read("farther_m", echo.farther_m, kDistance_m);
  read_time(table, "together_s", echo.together);
  table.read("straight_rad", echo.straight_rad, kTolerance_rad);
  table.read("approach_m", echo.approach_m, kDistance_m);
  table.refuse_unknown();
}

void read_patience(TomlTable table, PatienceSettings& patience) {
  table.read("somewhere_m", patience.somewhere_m, kDistance_m);
  table.read("forget_radius_m", patience.forget_radius_m, {0.0, 100.0});
  table.refuse_unknown();
}

}  // namespace

void read_sensing(TomlTable& algorithm, Config& config) {
  algorithm.read("corridor_m", config.passage.corridor_m, kLength_m);
  read_time(algorithm, "surface_memory_s", config.surfaces.duration);
  algorithm.read("touch_margin_m", config.obstacles.margin_m, kDistance_m);
  algorithm.read("touched_places", config.obstacles.places, {0, 10000});
  read_time(algorithm, "touch_patience_s", config.patience.timeout, 0.001);
  read_sonars(algorithm.table("sonar"), config.sonars);
  read_passage(algorithm.table("passage"), config.passage);
  read_neighbours(algorithm.table("neighbours"), config.neighbours);
  read_surfaces(algorithm.table("surfaces"), config.surfaces);
  read_obstacles(algorithm.table("obstacles"), config.obstacles);
  read_touch(algorithm.table("touch"), config.touch);
  read_vanishing_echo(algorithm.table("vanishing_echo"), config.vanishing_echo);
  read_patience(algorithm.table("patience"), config.patience);
}

}  // namespace caravan::agent
