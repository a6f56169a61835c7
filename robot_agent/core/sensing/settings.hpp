// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "robot_agent/core/types.hpp"

/// Parameters of sensing and memory. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// All sonars are alike.
struct Sonars {
  double aperture_rad = robot_model::kSonarAperture_rad;  ///< full cone of each
  double range_m = robot_model::kSonarRange_m;
  double longest_age_s = 1.0;  ///< older ranges are ignored: at cruise speed the robot has left the place

  bool operator==(const Sonars&) const = default;
};

/// The corridor that must be free of echoes on the way to a point. An echo's surface is assumed to extend to
/// both sides, across the sonar's axis.
struct Passage {
  double corridor_m = 0.6;         ///< full width
  double surface_m = 0.2;          ///< half the width of a surface
  double surface_per_metre = 0.3;  ///< its growth with the range

  bool operator==(const Passage&) const = default;
};

/// Other robots, as their WAITs report.
struct NeighbourMemory {
  Time presence = std::chrono::milliseconds{200};       ///< of a received robot; at least 1.2 WAIT periods
  Time duration = std::chrono::milliseconds{400};       ///< of a reported position; likewise
  Time extrapolation = std::chrono::milliseconds{200};  ///< how long it is assumed to move on
  double echo_m = 0.1;          ///< an echo this near to a robot's body is caused by it
  double echo_per_metre = 0.2;  ///< growth of this distance with the range

  bool operator==(const NeighbourMemory&) const = default;
};

/// Surfaces that the sonars saw, or the robot touched.
struct SurfaceMemory {
  Time duration = std::chrono::seconds{300};  ///< how long the robot keeps clear of them; at least `recent`
  Time recent = std::chrono::seconds{20};     ///< up to this age, and
  double recent_m = 3.0;                      ///< up to this distance from the robot, every echo counts
  double exact_range_m = 1.2;                 ///< echoes from farther away are too inexact
  double same_place_m = 0.05;                 ///< distance below which two places count as the same
  double reach_m = 0.8;                       ///< distance from the base within which places matter
  double robot_radius_m = 0.5;                ///< places this near to a reported position are forgotten
  double touched_ahead_m = 0.02;              ///< distance of a touched surface from the front of the body

  // Two echoes of a sonar give the direction of a wall at this distance from each other,
  double wall_shortest_m = 0.08;
  double wall_longest_m = 0.4;
  Time wall_time = std::chrono::seconds{1};  ///< within this time,
  double wall_cosine = 0.75;  ///< on a line at most this far from across the sonar's axis (cosine)
  std::vector<double> wall_extension_m = {0.1, 0.2, 0.3};  ///< distances beyond the last echo

  double cell_m = 0.05;        ///< side of a square of the map, which holds one place
  double high_range_m = 0.4;   ///< an echo from nearer than this is as high as the sonars
  double high_radius_m = 0.4;  ///< and so is everything within this distance

  bool operator==(const SurfaceMemory&) const = default;
};

/// Obstacles that the sonars do not see from close by.
struct ObstacleMemory {
  double margin_m = 0.35;       ///< assumed radius
  std::uint32_t places = 128;   ///< number remembered for the whole run; 0: none
  double same_place_m = 0.05;   ///< distance below which two places count as the same
  double overlap_m = 0.06;      ///< a place deeper inside the body is wrong
  double robot_m = 0.15;        ///< a touch this near to another robot's body is a touch of that robot
  double check_radius_m = 2.0;  ///< places within it are checked against what the sonars see

  bool operator==(const ObstacleMemory&) const = default;
};

/// What counts as a touch, by the wheels.
struct TouchSensing {
  double reached_share = 0.8;  ///< share of its command that a wheel has reached
  double lost_share = 0.75;    ///< share of its command below which it has then slowed
  double slowest_mps = 0.08;   ///< slower commands are not judged
  double pushed_mps = 0.03;    ///< deviation of the base's speed that tells front from rear contact
  Time longest_gap = std::chrono::milliseconds{50};  ///< sensor frames farther apart are not judged
  Time pause = std::chrono::milliseconds{500};       ///< shortest time between two touches

  bool operator==(const TouchSensing&) const = default;
};

/// When an echo that vanishes ahead counts as an obstacle lower than the sonars. An obstacle 0.1 m high
/// vanishes at about half a metre, a flatter one farther away.
struct EchoLoss {
  double seen_m = 2.1;       ///< largest range at which both forward sonars see it
  double one_thing_m = 0.3;  ///< largest difference between their ranges
  double nearest_m = 0.5;    ///< ranges between which
  double farthest_m = 1.3;   ///< it vanishes
  double farther_m = 0.3;    ///< an echo has vanished when its range exceeds the expected one by this
  Time together = std::chrono::milliseconds{500};  ///< longest time in which both vanish
  double straight_rad = 0.12;                      ///< largest change of heading
  double approach_m = 0.05;                        ///< smallest distance that the robot has approached it

  bool operator==(const EchoLoss&) const = default;
};

/// A robot without progress forgets places around it.
struct PatienceSettings {
  Time timeout = std::chrono::seconds{15};
  double somewhere_m = 0.5;      ///< smallest movement that counts as progress
  double forget_radius_m = 1.0;  ///< within which places are forgotten

  bool operator==(const PatienceSettings&) const = default;
};

}  // namespace caravan::agent
