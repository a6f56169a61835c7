// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {
namespace {

void read_recording(TomlTable table, RecordingSettings& recording) {
  table.read("sharp_turn_rad", recording.sharp_turn_rad, kTolerance_rad);
  table.read("shortest_m", recording.shortest_m, kDistance_m);
  table.refuse_unknown();
}

void read_following(TomlTable table, PathFollowing& following) {
  table.read("look_ahead_m", following.look_ahead_m, kLength_m);
  table.read("look_ahead_per_metre", following.look_ahead_per_metre, kPerMetre);
  table.read("sharp_turn_rad", following.sharp_turn_rad, kTolerance_rad);
  table.read("passed_m", following.passed_m, kDistance_m);
  table.read("lost_m", following.lost_m, kDistance_m);
  table.read("search_back", following.search_back, {0, 65535});
  table.read("search_ahead_m", following.search_ahead_m, kDistance_m);
  table.read("return_reached_m", following.return_reached_m, kLength_m);
  table.read("pick_up_m", following.pick_up_m, kDistance_m);
  table.read("end_m", following.end_m, kDistance_m);
  table.refuse_unknown();
}

void read_smoothing(TomlTable table, Smoothing& smoothing) {
  table.read("interval_m", smoothing.interval_m, kDistance_m);
  table.read("on_path_m", smoothing.on_path_m, kDistance_m);
  table.read("merge_m", smoothing.merge_m, kDistance_m);
  table.read("nested_gain_m", smoothing.nested_gain_m, kDistance_m);
  table.read("provisional_m", smoothing.provisional_m, kDistance_m);
  table.read("alike_m", smoothing.alike_m, kDistance_m);
  table.read("touch_room_m", smoothing.touch_room_m, kDistance_m);
  table.read("bend_room_m", smoothing.bend_room_m, kDistance_m);
  table.refuse_unknown();
}

void read_progress(TomlTable table, Progress& progress) {
  table.read("least_m", progress.least_m, kDistance_m);
  read_time(table, "timeout_s", progress.timeout, 0.001);
  table.read("wander_m", progress.wander_m, kDistance_m);
  table.read("wander_doublings", progress.wander_doublings, {0, 20});
  read_time(table, "wander_again_s", progress.wander_again);
  read_time(table, "wander_timeout_s", progress.wander_timeout);
  table.refuse_unknown();
}

void read_arrival(TomlTable table, Task& task) {
  table.read("crowded_m", task.crowded_m, kDistance_m);
  table.refuse_unknown();
}

}  // namespace

void read_paths(TomlTable& algorithm, Config& config) {
  algorithm.read("point_spacing_m", config.recording.spacing_m, {0.05, 100.0});
  algorithm.read("vision_radius_m", config.smoothing.vision_radius_m, kLength_m);
  algorithm.read("shortcut_gain_m", config.smoothing.gain_m, kLength_m);
  read_time(algorithm, "shortcut_pause_s", config.smoothing.pause);
  read_recording(algorithm.table("recording"), config.recording);
  read_following(algorithm.table("following"), config.following);
  read_smoothing(algorithm.table("smoothing"), config.smoothing);
}

void read_task(TomlTable& algorithm, Config& config) {
  algorithm.read("arrival_radius_m", config.task.arrival_radius_m, kLength_m);
  read_time(algorithm, "gripper_patience_s", config.task.gripper_patience, 0.001);
  read_arrival(algorithm.table("arrival"), config.task);
  read_progress(algorithm.table("progress"), config.progress);
}

}  // namespace caravan::agent
