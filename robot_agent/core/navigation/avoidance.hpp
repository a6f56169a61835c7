// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/manoeuvre.hpp"
#include "robot_agent/core/navigation/meeting.hpp"

namespace caravan::agent {

/// What a robot knows when something is in its way.
struct Encounter {
  const Perception& seen;
  const Manoeuvres& settings;
  double corridor_m = 0.6;        ///< full width that must be free of echoes
  double goal_bearing_rad = 0.0;  ///< where it wants to go, frame B
  double draw = 0.5;  ///< a random number in [0, 1): two robots shall not mirror each other for ever
  int attempt = 0;    ///< how often in a row, in this place
  std::optional<Meeting> meeting{};  ///< when the other has told where it is
};

/// The paper's rule for another robot (section 3.2): both turn slightly left, go forward a little, resume.
/// With no room on the left the robot stands a little and lets the other pass, which has it on its left;
/// every third time in the same place it goes round.
[[nodiscard]] Manoeuvre turn_slightly_left(const Encounter& encounter);

/// For an obstacle that sends no WAIT: turns to the free direction nearest to the goal, goes forward a
/// little, resumes. Nothing free: backs off and turns away.
[[nodiscard]] Manoeuvre go_round(const Encounter& encounter);

/// For a robot that does not come away: it touches something that its sonars do not see, or would. Backs off,
/// turns to the freer side, the other one at every second attempt and further each time, goes forward a
/// little.
[[nodiscard]] Manoeuvre free_itself(const Encounter& encounter);

}  // namespace caravan::agent
