// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of the agent's senses and memory. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// All sonars are alike.
struct Sonars {
  double aperture_rad = robot_model::kSonarAperture_rad;  ///< full cone of each
  double range_m = robot_model::kSonarRange_m;
  double longest_age_s = 1.0;  ///< an older reading does not count: a robot at cruise has left the place

  bool operator==(const Sonars&) const = default;
};

/// The strip that must be free of echoes on the way to a point. A surface is taken to reach so far on either
/// side of its echo, across the sonar's axis.
struct Passage {
  double corridor_m = 0.6;  ///< full width
  double surface_m = 0.2;
  double surface_per_metre = 0.3;  ///< the same, growing with the range

  bool operator==(const Passage&) const = default;
};

/// Other robots, as their WAITs tell.
struct NeighbourMemory {
  Time presence =
      std::chrono::milliseconds{200};  ///< one that was heard counts as near, 1.2 WAIT periods at least
  Time duration = std::chrono::milliseconds{400};       ///< where one told that it is counts; likewise
  Time extrapolation = std::chrono::milliseconds{200};  ///< it moves on as it told; then it may have stopped
  // An echo this near to a robot's body is that robot's; the sonar does not say where in its cone.
  double echo_m = 0.1;
  double echo_per_metre = 0.2;  ///< the same, growing with the distance

  bool operator==(const NeighbourMemory&) const = default;
};

/// Surfaces that the sonars saw, or the robot touched.
struct SurfaceMemory {
  Time duration = std::chrono::seconds{300};  ///< kept clear of for so long; at least `recent`
  Time recent = std::chrono::seconds{20};     ///< for so long each echo counts that lies
  double recent_m = 3.0;                      ///< within this of the robot
  double exact_range_m = 1.2;     ///< an echo from farther away does not say well enough where it is from
  double same_place_m = 0.05;     ///< a place this near to one that is known is that one
  double reach_m = 0.8;           ///< places within it are kept clear of
  double robot_radius_m = 0.5;    ///< what lies within it of a robot that tells where it is was that robot
  double touched_ahead_m = 0.02;  ///< where something touched is taken to be, in front of the body

  // Two echoes of a sonar on one wall tell its direction when they are this far apart,
  double wall_shortest_m = 0.08;
  double wall_longest_m = 0.4;
  Time wall_time = std::chrono::seconds{1};  ///< this soon after each other,
  double wall_cosine = 0.75;  ///< and on a line that the sonar could see: cosine of the angle across its axis
  std::vector<double> wall_extension_m = {0.1, 0.2, 0.3};  ///< so far beyond the last echo it goes on

  double cell_m = 0.05;  ///< side of a square of the map, which holds one place
  double high_range_m =
      0.4;  ///< seen from nearer than this: as high as the sonars (0.13 m, or less, vanishes)
  double high_radius_m = 0.4;  ///< and so is what lies around it

  bool operator==(const SurfaceMemory&) const = default;
};

/// Obstacles that the sonars do not see from close by.
struct ObstacleMemory {
  double margin_m = 0.35;      ///< half the size that one is taken to have
  std::uint32_t places = 128;  ///< so many are remembered, for the whole run; 0: none
  double same_place_m = 0.05;  ///< a place this near to one that is known is that one
  double overlap_m = 0.06;     ///< a place deeper inside the body than this is wrong
  double robot_m = 0.15;       ///< when a robot's body is this near to the touch, it is what was touched
  double check_radius_m =
      2.0;  ///< within it a place is forgotten that proves to be high; farther, no echo is new

  bool operator==(const ObstacleMemory&) const = default;
};

/// What counts as a touch, by the wheels.
struct TouchSensing {
  double reached_share = 0.8;  ///< a wheel that has turned at this share of its command
  double lost_share = 0.75;    ///< and then turns at less than this one is held
  double slowest_mps = 0.08;   ///< slower commands say nothing
  double pushed_mps = 0.03;    ///< in a turn on the spot: the base is pushed at least this fast
  Time longest_gap = std::chrono::milliseconds{50};  ///< sensor frames farther apart are not judged
  Time pause = std::chrono::milliseconds{500};       ///< within it, it is the same touch

  bool operator==(const TouchSensing&) const = default;
};

/// When an echo that vanishes ahead is an obstacle lower than the sonars: one lower by a hand's breadth
/// vanishes at half a metre, a flat one at a metre.
struct EchoLoss {
  double seen_m = 2.1;       ///< both sonars that look ahead see something nearer than this,
  double one_thing_m = 0.3;  ///< at distances that differ by less
  double nearest_m = 0.5;    ///< it vanishes between here
  double farthest_m = 1.3;   ///< and here:
  double farther_m = 0.3;    ///< both echoes come from farther than they should by this,
  Time together = std::chrono::milliseconds{500};  ///< both within this time,
  double straight_rad = 0.12;                      ///< while the heading has changed by less
  double approach_m = 0.05;                        ///< and the robot has come nearer by this

  bool operator==(const EchoLoss&) const = default;
};

/// A robot that gets nowhere forgets what it remembers around it.
struct PatienceSettings {
  Time timeout = std::chrono::seconds{15};
  double somewhere_m = 0.5;      ///< so far from where it was it got somewhere
  double forget_radius_m = 1.0;  ///< what lies within it is forgotten

  bool operator==(const PatienceSettings&) const = default;
};

}  // namespace caravan::agent
