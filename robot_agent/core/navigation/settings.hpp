// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What a scenario can say of how the agent moves. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// Algorithm 2.
struct Exploration {
  double step_m = 1.0;              ///< to the next location
  double spread_rad = 1.05;         ///< a new direction is drawn within this of the heading, at first
  double detection_radius_m = 4.0;  ///< the destination is seen within it

  bool operator==(const Exploration&) const = default;
};

/// Speeds, and what is too near.
struct Driving {
  double cruise_mps = 0.975;
  double slow_mps = 0.29;
  double slow_below_m = 1.0;  ///< an echo ahead nearer than this: slow
  double too_close_m = 0.5;   ///< nearer than this: avoid

  bool operator==(const Driving&) const = default;
};

/// When something ahead is another robot in the way.
struct MeetingRule {
  double echo_m = 1.2;  ///< an echo ahead nearer than this while a WAIT is heard

  bool operator==(const MeetingRule&) const = default;
};

/// The dynamic window under everything that the robot does.
struct KeepClear {
  double robots_m = 0.05;  ///< between two robots' bodies; it needs to be told where they are

  bool operator==(const KeepClear&) const = default;
};

}  // namespace caravan::agent
