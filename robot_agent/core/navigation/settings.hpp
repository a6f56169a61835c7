// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of how the agent moves. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// Algorithm 2, and the approach to the destination.
struct Exploration {
  double step_m = 1.0;       ///< to the next location
  double spread_rad = 1.05;  ///< a new direction is drawn within this of the heading, at first
  double widening = 1.2;     ///< factor of the spread after each draw that meets an echo
  std::uint32_t draws = 24;  ///< at most, for one location
  double turn_room_m = 0.5;  ///< free space wanted behind the new location, so that the robot can turn there
  double reached_m = 0.3;    ///< a location this near is reached
  Time location_timeout = std::chrono::seconds{6};  ///< then another one is drawn

  double detection_radius_m = 4.0;              ///< the destination is seen within it
  double sight_surface_m = 0.1;                 ///< half the width for which an echo hides it
  double sight_surface_per_metre = 0.2;         ///< the same, growing with the range
  Time out_of_sight = std::chrono::seconds{1};  ///< not seen for so long, it is out of reach from here:
  Time look_away = std::chrono::seconds{8};     ///< for so long it is not looked for

  bool operator==(const Exploration&) const = default;
};

/// What the motors give, or a little less.
struct Acceleration {
  double linear_mps2 = 3.0;
  double angular_radps2 = 12.0;

  bool operator==(const Acceleration&) const = default;
};

/// Speeds, steering, and what is too near.
struct Driving {
  double cruise_mps = 0.975;
  double slow_mps = 0.29;
  double slow_below_m = 1.0;  ///< an echo ahead nearer than this: slow
  double too_close_m = 0.5;   ///< nearer than this: avoid
  double goal_room_m = 0.15;  ///< at a goal nearer than too_close_m this much is enough
  double facing_rad = 0.5;    ///< something ahead matters when the goal lies within this of ahead
  Acceleration acceleration;

  // The controller of the heading.
  double turn_gain_per_s = 3.0;    ///< rate of turn for each radian of bearing
  double turn_limit_radps = 2.5;   ///< fastest
  double turn_in_place_rad = 0.8;  ///< from this bearing on; towards it the robot gets slower

  // Away from what is beside it: walls end in corners, which return no echo.
  double wall_room_m = 0.3;    ///< free space on either side that a driving robot tries to keep
  double wall_turn_rad = 0.5;  ///< the goal's bearing is turned away by up to this
  double wall_window_m = 0.3;  ///< an echo counts as beside it so far ahead of the axle and behind it

  bool operator==(const Driving&) const = default;
};

/// When something ahead is another robot in the way.
struct MeetingRule {
  // One that does not tell where it is, while a WAIT is heard.
  double echo_m = 1.2;       ///< an echo ahead nearer than this
  double closing_mps = 0.2;  ///< that comes nearer faster than this; slower, it drives ahead: follow it
  Time closing_period = std::chrono::milliseconds{200};  ///< between the ranges that tell how fast
  // A robot that turns shows its corner and vanishes from the sonars.
  Time lost_echo = std::chrono::seconds{2};  ///< an echo that vanishes is believed for so long,
  double lost_echo_range_m = 1.5;            ///< when it was this near,
  double lost_echo_jump_m = 0.3;             ///< and went away by more than this from one step to the next,
  double lost_echo_turn_rad = 0.4;           ///< until the heading has changed by this

  // One that tells where it is.
  double ahead_rad = 1.2;         ///< it lies within this of the way to the goal,
  double standing_mps = 0.1;      ///< and stands, which slower ones do,
  double oncoming_cosine = -0.5;  ///< or comes: cosine between the two directions of driving
  double time_s = 2.5;            ///< and the closest point of approach is nearer than this in time

  bool operator==(const MeetingRule&) const = default;
};

/// Short sequences of blind movements. A `spread` is the range of a random part: two robots shall not mirror
/// each other for ever.
struct Manoeuvres {
  double speed_share = 0.6;  ///< of the cruise speed, at most
  double reverse_mps = 0.3;
  double heading_tolerance_rad = 0.1;  ///< a turn ends this near to its heading
  double ahead_m = 0.3;                ///< a leg forwards ends with less free space ahead of the body,
  double behind_m = 0.08;              ///< one backwards with less behind it,
  Time leg_timeout = std::chrono::seconds{4};  ///< and any after this time

  // What makes a direction free.
  double room_m = 0.9;             ///< free distance from the base
  double surface_per_metre = 0.2;  ///< half the width of an echo's surface, growing with the range
  double robot_radius_m = 0.25;    ///< robots that told where they are count as discs
  double robot_close_m = 0.9;      ///< one this near must not be approached at all:
  double robot_cosine = 0.1;       ///< cosine of the angle to it, above which the robot comes nearer

  // Letting another one pass.
  Time pass_time = std::chrono::milliseconds{800};
  double pass_spread_s = 1.0;
  // Slightly left in motion, when the other told where it is.
  double veer_rad = 0.55;  ///< from the way to the goal
  double veer_spread_rad = 0.15;
  double veer_m = 0.7;
  double veer_right_m = 0.3;  ///< one that passes this far off on the left: to the right
  // Slightly left on the spot, then forward.
  double left_rad = 0.5;
  double left_spread_rad = 0.3;
  double left_step_rad = 0.4;   ///< further, where a robot stands so close that this does not lead past it,
  double left_limit_rad = 2.0;  ///< up to this
  double left_m = 0.5;
  double left_spread_m = 0.4;
  // Round an obstacle.
  std::vector<double> round_rad = {0.4, 0.7, 1.0, 1.3, 1.7, 2.1, 2.6, 3.1};  ///< from the goal, either side
  double round_m = 0.5;
  double round_spread_m = 0.3;
  // Free: back, turn, forward; each further by a step with every attempt, up to so many.
  double free_back_m = 0.25;
  double free_back_step_m = 0.08;
  double free_turn_rad = 0.6;
  double free_turn_step_rad = 0.25;
  double free_turn_spread_rad = 0.3;
  double free_forward_m = 0.4;
  double free_forward_step_m = 0.1;
  std::uint32_t free_steps = 6;
  double free_side_rad = 0.9;  ///< the sides are compared at this bearing

  bool operator==(const Manoeuvres&) const = default;
};

/// A robot that does not come on.
struct Recovery {
  // It is stuck when it has not moved so far
  double stuck_moved_m = 0.12;
  double stuck_turned_rad = 0.25;
  // although it has been told to go this far.
  double stuck_commanded_m = 0.5;
  double stuck_commanded_rad = 2.0;
  // Held: kept by keep_clear() from what it wants to do.
  double held_mps = 0.3;                            ///< the speeds of both wheels together differ by this,
  Time held_time = std::chrono::milliseconds{700};  ///< for so long

  // Trouble is the same trouble again when it comes this soon and this near.
  Time again_time = std::chrono::seconds{15};
  double again_m = 1.0;
  std::uint32_t attempts = 20;  ///< after so many, what is remembered of surfaces holds the robot no longer
  double back_off_m = 0.4;      ///< before it turns away from a shortcut that was blocked

  bool operator==(const Recovery&) const = default;
};

/// The dynamic window under everything that the robot does.
struct KeepClear {
  double robots_m = 0.05;        ///< between two robots' bodies; it needs to be told where they are
  double surfaces_m = 0.04;      ///< between the body and a remembered place
  double contact_m = 0.005;      ///< nearer than this it touches, and may drive along
  double inside_m = 0.05;        ///< a place deeper inside the body than this cannot be there
  double kept_share = 0.7;       ///< of a space that is too small already, so much must be kept
  double body_weight = 3.0;      ///< of space between bodies, as against that between axles
  double robots_within_m = 1.7;  ///< between the bases; farther off both can still brake
  double echo_m = 0.2;           ///< free space to an echo where another twist than the wanted one leads
  double arc_s = 0.3;            ///< it is looked for in the direction of the twist after this time,
  double arc_limit_rad = 0.5;    ///< at most so far aside

  double command_s = 0.12;          ///< a twist lasts so long; then the robot brakes
  double prediction_step_s = 0.08;  ///< between the poses of the predicted trajectory

  // The cost of a candidate: how much it differs from what is wanted.
  std::vector<double> turns_radps = {0.7, 1.4, 2.5};  ///< candidates, to either side
  double linear_scale_mps = 0.5;                      ///< a difference that costs 1
  double angular_scale_radps = 2.0;                   ///< likewise
  double reverse_cost = 0.5;                          ///< of the opposite direction
  double right_cost = 0.05;  ///< of turning to the right of what is wanted: the rule for meetings

  bool operator==(const KeepClear&) const = default;
};

}  // namespace caravan::agent
