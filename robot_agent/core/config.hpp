// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "robot_agent/core/sharing_policy.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::agent {

/// Everything one agent is told before it starts. Defaults are the paper's text values where it gives one.
struct Config {
  RobotId id{1};
  std::uint64_t seed = 1;

  // The task. `destination` is read by sees_destination() only: sight of it is simulated by distance, as in
  // the paper.
  Point source{0.0, 0.0};
  Point destination{0.0, 0.0};
  double service_radius_m = 1.5;

  // The body.
  double wheel_limit_mps = robot_model::kWheelLimit_mps;
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
  double body_ahead_m = robot_model::kBodyAhead_m;  ///< from the axle to the front
  double body_length_m = robot_model::kBodyLength_m;
  double body_width_m = robot_model::kBodyWidth_m;
  double sonar_aperture_rad = robot_model::kSonarAperture_rad;  ///< full cone of each sonar
  double sonar_range_m = robot_model::kSonarRange_m;
  bool robots_are_solid = true;  ///< false: robots pass through one another, so nobody gives way to anybody

  // Exploration (Algorithm 2).
  double exploration_step_m = 1.0;       ///< to the next location
  double exploration_spread_rad = 1.05;  ///< a new direction is drawn within this of the heading, at first

  // Driving.
  double cruise_mps = 0.975;
  double slow_mps = 0.29;
  double slow_below_m = 1.0;  ///< an echo ahead nearer than this: slow
  double too_close_m = 0.5;   ///< nearer than this: avoid
  double meeting_m = 1.2;     ///< an echo ahead nearer than this while a WAIT is heard: another robot
  double arrival_radius_m = 1.0;
  std::chrono::nanoseconds gripper_patience =
      std::chrono::milliseconds{300};  ///< for the gripper to hold, or not to, once it was told
  double touch_margin_m = 0.35;        ///< half the size that something touched and unseen is taken to have
  std::uint32_t touched_places = 128;  ///< so many are remembered, for the whole run; 0: none
  std::chrono::nanoseconds touch_patience =
      std::chrono::seconds{15};  ///< a robot that gets nowhere for so long forgets those around it
  std::chrono::nanoseconds surface_memory = std::chrono::seconds{
      300};  ///< surfaces that it saw or touched are kept clear of for so long; at least 20 s
  bool wait_tells_place = true;  ///< WAIT says where its sender is and how it moves
  double keep_clear_m = 0.05;    ///< between two robots' bodies; it needs to be told where they are

  // Path record and smoothing (Algorithm 4).
  double point_spacing_m = 1.0;
  double vision_radius_m = 6.0;
  double detection_radius_m = 4.0;  ///< the destination is seen within it
  double corridor_m = 0.6;          ///< full width that must be free of echoes on the way to a candidate
  double shortcut_gain_m = 0.05;    ///< a shortcut that saves less is not worth it
  std::chrono::nanoseconds shortcut_pause =
      std::chrono::minutes{10};  ///< before a shortcut that was blocked is tried again

  // Communication (Algorithms 5 to 7).
  Sharing sharing = Sharing::kFull;
  bool stop_to_exchange = true;  ///< false: drives on while it negotiates and exchanges
  std::chrono::nanoseconds sharing_starts = std::chrono::minutes{15};
  std::chrono::nanoseconds recontact_after = std::chrono::minutes{10};
  std::chrono::nanoseconds wait_period{0};  ///< longest time between WAITs; 0: every step
  std::chrono::nanoseconds accept_period = std::chrono::seconds{1};
  std::uint32_t accept_attempts = 8;
  std::chrono::nanoseconds session_timer = std::chrono::seconds{10};
  std::uint32_t points_per_frame = 20;
  std::uint32_t channel_count = robot_model::kChannelCount;
  std::uint32_t mtu_bytes = robot_model::kMtu_bytes;
};

}  // namespace caravan::agent
