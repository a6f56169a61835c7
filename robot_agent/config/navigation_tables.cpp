// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {
namespace {

void read_exploration(TomlTable table, Exploration& exploration) {
  table.read("widening", exploration.widening, {1.0, 10.0});
  table.read("draws", exploration.draws, {1, 1000});
  table.read("turn_room_m", exploration.turn_room_m, kDistance_m);
  table.read("reached_m", exploration.reached_m, kDistance_m);
  read_time(table, "location_timeout_s", exploration.location_timeout);
  table.read("sight_surface_m", exploration.sight_surface_m, kDistance_m);
  table.read("sight_surface_per_metre", exploration.sight_surface_per_metre, kPerMetre);
  read_time(table, "out_of_sight_s", exploration.out_of_sight);
  read_time(table, "look_away_s", exploration.look_away);
  table.refuse_unknown();
}

void read_driving(TomlTable table, Driving& driving, Body& body) {
  table.read("goal_room_m", driving.goal_room_m, kDistance_m);
  table.read("facing_rad", driving.facing_rad, kTolerance_rad);
  table.read("side_margin_m", body.side_margin_m, kDistance_m);
  table.read("acceleration_mps2", driving.acceleration.linear_mps2, {0.01, 100.0});
  table.read("angular_acceleration_radps2", driving.acceleration.angular_radps2, {0.01, 1000.0});
  table.read("turn_gain_per_s", driving.turn_gain_per_s, {0.01, 100.0});
  table.read("turn_limit_radps", driving.turn_limit_radps, {0.01, 100.0});
  table.read("turn_in_place_rad", driving.turn_in_place_rad, {0.01, std::numbers::pi});
  table.read("wall_room_m", driving.wall_room_m, kDistance_m);
  table.read("wall_turn_rad", driving.wall_turn_rad, kTolerance_rad);
  table.read("wall_window_m", driving.wall_window_m, kDistance_m);
  table.refuse_unknown();
}

void read_meeting(TomlTable table, MeetingRule& rule) {
  table.read("closing_mps", rule.closing_mps, kSpeed_mps);
  read_time(table, "closing_period_s", rule.closing_period, 0.001);
  read_time(table, "lost_echo_s", rule.lost_echo);
  table.read("lost_echo_range_m", rule.lost_echo_range_m, kDistance_m);
  table.read("lost_echo_jump_m", rule.lost_echo_jump_m, kDistance_m);
  table.read("lost_echo_turn_rad", rule.lost_echo_turn_rad, kTolerance_rad);
  table.read("ahead_rad", rule.ahead_rad, kTolerance_rad);
  table.read("standing_mps", rule.standing_mps, kSpeed_mps);
  table.read("oncoming_cosine", rule.oncoming_cosine, {-1.0, 1.0});
  table.read("time_s", rule.time_s, {0.0, 1000.0});
  table.refuse_unknown();
}

void read_free_directions(TomlTable& table, Manoeuvres& manoeuvres) {
  table.read("room_m", manoeuvres.room_m, kDistance_m);
  table.read("surface_per_metre", manoeuvres.surface_per_metre, kPerMetre);
  table.read("robot_radius_m", manoeuvres.robot_radius_m, kDistance_m);
  table.read("robot_close_m", manoeuvres.robot_close_m, kDistance_m);
  table.read("robot_cosine", manoeuvres.robot_cosine, {-1.0, 1.0});
}

void read_giving_way(TomlTable& table, Manoeuvres& manoeuvres) {
  read_time(table, "pass_s", manoeuvres.pass_time);
  table.read("pass_spread_s", manoeuvres.pass_spread_s, {0.0, 1000.0});
  table.read("veer_rad", manoeuvres.veer_rad, kTolerance_rad);
  table.read("veer_spread_rad", manoeuvres.veer_spread_rad, kTolerance_rad);
  table.read("veer_m", manoeuvres.veer_m, kDistance_m);
  table.read("veer_right_m", manoeuvres.veer_right_m, kDistance_m);
  table.read("left_rad", manoeuvres.left_rad, kTolerance_rad);
  table.read("left_spread_rad", manoeuvres.left_spread_rad, kTolerance_rad);
  table.read("left_step_rad", manoeuvres.left_step_rad, {0.01, std::numbers::pi});
  table.read("left_limit_rad", manoeuvres.left_limit_rad, kTolerance_rad);
  table.read("left_m", manoeuvres.left_m, kDistance_m);
  table.read("left_spread_m", manoeuvres.left_spread_m, kDistance_m);
}

void read_coming_away(TomlTable& table, Manoeuvres& manoeuvres) {
  table.read("round_rad", manoeuvres.round_rad, kTolerance_rad);
  table.read("round_m", manoeuvres.round_m, kDistance_m);
  table.read("round_spread_m", manoeuvres.round_spread_m, kDistance_m);
  table.read("free_back_m", manoeuvres.free_back_m, kDistance_m);
  table.read("free_back_step_m", manoeuvres.free_back_step_m, kDistance_m);
  table.read("free_turn_rad", manoeuvres.free_turn_rad, kTolerance_rad);
  table.read("free_turn_step_rad", manoeuvres.free_turn_step_rad, kTolerance_rad);
  table.read("free_turn_spread_rad", manoeuvres.free_turn_spread_rad, kTolerance_rad);
  table.read("free_forward_m", manoeuvres.free_forward_m, kDistance_m);
  table.read("free_forward_step_m", manoeuvres.free_forward_step_m, kDistance_m);
  table.read("free_steps", manoeuvres.free_steps, {0, 1000});
  table.read("free_side_rad", manoeuvres.free_side_rad, kTolerance_rad);
}

void read_manoeuvres(TomlTable table, Manoeuvres& manoeuvres) {
  table.read("speed_share", manoeuvres.speed_share, kShare);
  table.read("reverse_mps", manoeuvres.reverse_mps, {0.001, 100.0});
  table.read("heading_tolerance_rad", manoeuvres.heading_tolerance_rad, {0.001, std::numbers::pi});
  table.read("ahead_m", manoeuvres.ahead_m, kDistance_m);
  table.read("behind_m", manoeuvres.behind_m, kDistance_m);
  read_time(table, "leg_timeout_s", manoeuvres.leg_timeout, 0.001);
  read_free_directions(table, manoeuvres);
  read_giving_way(table, manoeuvres);
  read_coming_away(table, manoeuvres);
  table.refuse_unknown();
}

void read_recovery(TomlTable table, Recovery& recovery) {
  table.read("stuck_moved_m", recovery.stuck_moved_m, kDistance_m);
  table.read("stuck_turned_rad", recovery.stuck_turned_rad, kTolerance_rad);
  table.read("stuck_commanded_m", recovery.stuck_commanded_m, kLength_m);
  table.read("stuck_commanded_rad", recovery.stuck_commanded_rad, {0.001, 1000.0});
  table.read("held_mps", recovery.held_mps, {0.001, 100.0});
  read_time(table, "held_s", recovery.held_time);
  read_time(table, "again_s", recovery.again_time);
  table.read("again_m", recovery.again_m, kDistance_m);
  table.read("attempts", recovery.attempts, {1, 1000000});
  table.read("back_off_m", recovery.back_off_m, kDistance_m);
  table.refuse_unknown();
}

void read_keep_clear(TomlTable table, KeepClear& settings) {
  table.read("surfaces_m", settings.surfaces_m, kDistance_m);
  table.read("contact_m", settings.contact_m, kDistance_m);
  table.read("inside_m", settings.inside_m, kDistance_m);
  table.read("kept_share", settings.kept_share, kShare);
  table.read("body_weight", settings.body_weight, {0.0, 1000.0});
  table.read("robots_within_m", settings.robots_within_m, kDistance_m);
  table.read("echo_m", settings.echo_m, kDistance_m);
  table.read("arc_s", settings.arc_s, {0.0, 10.0});
  table.read("arc_limit_rad", settings.arc_limit_rad, kTolerance_rad);
  table.read("command_s", settings.command_s, {0.0, 10.0});
  table.read("prediction_step_s", settings.prediction_step_s, {0.001, 1.0});
  table.read("turns_radps", settings.turns_radps, {0.0, 100.0});
  table.read("linear_scale_mps", settings.linear_scale_mps, {0.001, 1000.0});
  table.read("angular_scale_radps", settings.angular_scale_radps, {0.001, 1000.0});
  table.read("reverse_cost", settings.reverse_cost, {0.0, 1000.0});
  table.read("right_cost", settings.right_cost, {0.0, 1000.0});
  table.refuse_unknown();
}

}  // namespace

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
  read_exploration(algorithm.table("exploration"), config.exploration);
  read_driving(algorithm.table("driving"), config.driving, config.body);
  read_meeting(algorithm.table("meeting"), config.meeting);
  read_manoeuvres(algorithm.table("manoeuvres"), config.manoeuvres);
  read_recovery(algorithm.table("recovery"), config.recovery);
  read_keep_clear(algorithm.table("keep_clear"), config.keep_clear);
}

}  // namespace caravan::agent
