// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/manoeuvre.hpp"
#include "robot_agent/core/navigation/meeting.hpp"

namespace caravan::agent {

/// A robot or an obstacle in the way, as input to the manoeuvres below.
struct Encounter {
  const Perception& seen;
  const Manoeuvres& settings;
  double corridor_m = 0.6;           ///< full width that must be free of echoes
  double goal_bearing_rad = 0.0;     ///< bearing of the goal, frame B
  double draw = 0.5;                 ///< random number in [0, 1): keeps two robots from mirroring each other
  int attempt = 0;                   ///< number of previous attempts in a row at this place
  std::optional<Meeting> meeting{};  ///< set when the other robot reported its position
};

/// The paper's rule for another robot (section 3.2): both turn slightly left, drive forward a little, and
/// resume. If the other robot reported its position, this one veers left without stopping, or right when the
/// other passes on the left with enough room. Without free space there the robot pauses and lets the other
/// pass; at every third attempt in the same place it goes round instead.
[[nodiscard]] Manoeuvre turn_slightly_left(const Encounter& encounter);

/// For an obstacle that sends no WAIT: turns to the free direction nearest to the goal and drives forward a
/// little. If no direction is free, as free_itself().
[[nodiscard]] Manoeuvre go_round(const Encounter& encounter);

/// For a robot that is stuck: it touches something outside its sonars' view, or its wheels slip. It backs
/// off, turns, and drives forward a little. It turns to the side with more free space, at every second
/// attempt to the other one, and further with each attempt.
[[nodiscard]] Manoeuvre free_itself(const Encounter& encounter);

}  // namespace caravan::agent
