// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "robot_agent/core/types.hpp"

/// Parameters of motion. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// Algorithm 2, and the approach to the destination.
struct Exploration {
  double step_m = 1.0;       ///< to the next location
  double spread_rad = 1.05;  ///< initial range of directions to either side of the heading
  double widening = 1.2;     ///< factor of this range after each draw that meets an echo
  std::uint32_t draws = 24;  ///< most draws for one location
  double turn_room_m = 0.5;  ///< free space behind the new location, to turn there
  double reached_m = 0.3;    ///< distance at which a location is reached
  Time location_timeout = std::chrono::seconds{6};  ///< then another location is drawn

  double detection_radius_m = 4.0;              ///< distance within which the destination is seen
  double sight_surface_m = 0.1;                 ///< half the width of an echo's surface that may hide it
  double sight_surface_per_metre = 0.2;         ///< its growth with the range
  Time out_of_sight = std::chrono::seconds{1};  ///< then the approach is given up
  Time look_away = std::chrono::seconds{8};     ///< and the destination ignored for this time

  bool operator==(const Exploration&) const = default;
};

/// What the motors reach, or slightly less.
struct Acceleration {
  double linear_mps2 = 3.0;
  double angular_radps2 = 12.0;

  bool operator==(const Acceleration&) const = default;
};

/// Speeds, steering and clearances.
struct Driving {
  double cruise_mps = 0.975;
  double slow_mps = 0.29;
  double slow_below_m = 1.0;  ///< with an echo ahead nearer than this: slow
  double too_close_m = 0.5;   ///< with an echo nearer than this: avoid
  double goal_room_m = 0.15;  ///< free space that suffices when the goal is nearer than too_close_m
  double facing_rad = 0.5;    ///< an obstacle ahead matters when the goal's bearing is smaller
  Acceleration acceleration;

  // Heading controller.
  double turn_gain_per_s = 3.0;    ///< rate of turn for each radian of bearing
  double turn_limit_radps = 2.5;   ///< highest rate of turn
  double turn_in_place_rad = 0.8;  ///< from this bearing on; below it the speed falls with the bearing

  // Clearance from walls beside the robot: they end in corners, which return no echo.
  double wall_room_m = 0.3;    ///< free space on either side that a driving robot tries to keep
  double wall_turn_rad = 0.5;  ///< largest change of the bearing
  double wall_window_m = 0.3;  ///< an echo this far ahead of the axle or behind it counts as beside the robot

  bool operator==(const Driving&) const = default;
};

/// When another robot is in the way.
struct MeetingRule {
  // A robot that does not report its position, while a WAIT is received.
  double echo_m = 1.2;       ///< largest range of its echo
  double closing_mps = 0.2;  ///< an echo that approaches more slowly drives ahead: follow it
  Time closing_period = std::chrono::milliseconds{200};  ///< between the two ranges that give this speed
  // A turning robot shows its corner and vanishes from the sonars.
  Time lost_echo = std::chrono::seconds{2};  ///< how long a vanished echo is kept
  double lost_echo_range_m = 1.5;            ///< largest range at which it is kept
  double lost_echo_jump_m = 0.3;             ///< growth of the range in one step that counts as vanishing
  double lost_echo_turn_rad = 0.4;           ///< change of heading that ends it

  // A robot that reports its position.
  double ahead_rad = 1.2;         ///< largest angle from the way to the goal
  double standing_mps = 0.1;      ///< slower robots count as standing
  double oncoming_cosine = -0.5;  ///< oncoming below this cosine of the angle between both directions
  double time_s = 2.5;            ///< longest time to the closest point of approach

  bool operator==(const MeetingRule&) const = default;
};

/// Short sequences of movements without regard to the goal. A `spread` is the range of a random part: it
/// keeps two robots from mirroring each other.
struct Manoeuvres {
  double speed_share = 0.6;  ///< highest speed as a share of the cruise speed
  double reverse_mps = 0.3;
  double heading_tolerance_rad = 0.1;          ///< of the heading at which a turn ends
  double ahead_m = 0.3;                        ///< a leg forwards ends with less free space ahead of the body
  double behind_m = 0.08;                      ///< a leg backwards ends with less behind it
  Time leg_timeout = std::chrono::seconds{4};  ///< longest leg

  // A free direction.
  double room_m = 0.9;             ///< free distance from the base
  double surface_per_metre = 0.2;  ///< half the width of an echo's surface, for each metre of range
  double robot_radius_m = 0.25;    ///< of the disc that stands for a robot with a reported position
  double robot_close_m = 0.9;      ///< a robot this near must not be approached
  double robot_cosine = 0.1;       ///< a movement approaches it above this cosine

  // Waiting for the other robot to pass.
  Time pass_time = std::chrono::milliseconds{800};
  double pass_spread_s = 1.0;
  // Slightly left while moving, when the other robot reported its position.
  double veer_rad = 0.55;  ///< from the way to the goal
  double veer_spread_rad = 0.15;
  double veer_m = 0.7;
  double veer_right_m = 0.3;  ///< to the right, when the other passes on the left at a larger distance
  // Slightly left on the spot, then forward.
  double left_rad = 0.5;
  double left_spread_rad = 0.3;
  double left_step_rad = 0.4;   ///< a larger angle is tried when a robot is in the way,
  double left_limit_rad = 2.0;  ///< up to this
  double left_m = 0.5;
  double left_spread_m = 0.4;
  // Around an obstacle.
  std::vector<double> round_rad = {0.4, 0.7, 1.0, 1.3, 1.7, 2.1, 2.6, 3.1};  ///< to either side of the goal
  double round_m = 0.5;
  double round_spread_m = 0.3;
  // Getting free: back, turn, forward; each larger by a step with every attempt, up to free_steps.
  double free_back_m = 0.25;
  double free_back_step_m = 0.08;
  double free_turn_rad = 0.6;
  double free_turn_step_rad = 0.25;
  double free_turn_spread_rad = 0.3;
  double free_forward_m = 0.4;
  double free_forward_step_m = 0.1;
  std::uint32_t free_steps = 6;
  double free_side_rad = 0.9;  ///< bearing at which both sides are compared

  bool operator==(const Manoeuvres&) const = default;
};

/// A robot without progress.
struct Recovery {
  // The robot is stuck when it moves less than this
  double stuck_moved_m = 0.12;
  double stuck_turned_rad = 0.25;
  // while its commands amount to this.
  double stuck_commanded_m = 0.5;
  double stuck_commanded_rad = 2.0;
  // The robot is held by keep_clear()
  double held_mps = 0.3;  ///< when the speeds of both wheels together are changed by this
  Time held_time = std::chrono::milliseconds{700};  ///< for longer than this

  // Events count as the same trouble within this time and distance.
  Time again_time = std::chrono::seconds{15};
  double again_m = 1.0;
  std::uint32_t attempts = 20;  ///< number after which remembered surfaces are ignored
  double back_off_m = 0.4;      ///< before it turns away from a blocked shortcut

  bool operator==(const Recovery&) const = default;
};

/// The dynamic window that filters every motion.
struct KeepClear {
  double robots_m = 0.05;    ///< clearance between the bodies of two robots, if their position is reported
  double surfaces_m = 0.04;  ///< clearance between the body and a remembered surface point
  double contact_m = 0.005;  ///< a nearer point is in contact: the robot may slide along it
  double inside_m = 0.05;    ///< a point deeper inside the body is wrong
  double kept_share = 0.7;   ///< share of a clearance that is already too small and must be kept
  double body_weight = 3.0;  ///< of clearance between bodies relative to that between axles
  double robots_within_m = 1.7;  ///< between the bases; farther away both can still brake
  double echo_m = 0.2;           ///< free space to an echo that a twist other than the wanted one requires,
  double arc_s = 0.3;            ///< measured in the direction of the twist after this time,
  double arc_limit_rad = 0.5;    ///< up to this angle

  double command_s = 0.12;          ///< duration of a twist before the robot brakes
  double prediction_step_s = 0.08;  ///< between the poses of the predicted trajectory

  // Candidates, and what they cost.
  std::vector<double> turns_radps = {0.7, 1.4, 2.5};  ///< rates of turn, to either side
  double linear_scale_mps = 0.5;                      ///< difference from the wanted twist that costs 1
  double angular_scale_radps = 2.0;                   ///< likewise
  double reverse_cost = 0.5;                          ///< of the opposite direction
  double right_cost = 0.05;  ///< of turning to the right of the wanted twist: the rule for meetings

  bool operator==(const KeepClear&) const = default;
};

}  // namespace caravan::agent
