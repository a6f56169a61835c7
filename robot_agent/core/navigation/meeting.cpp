// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/meeting.hpp"

#include <cmath>
#include <limits>

namespace caravan::agent {
std::optional<Meeting> find_meeting(const Velocity& wanted, const Perception& seen, const MeetingRule& rule,
                                    const Body& body, double keep_clear_m) {
  const Point driving = direction(seen.yaw_WB_rad + wanted.bearing_rad);
  const double half_diagonal = std::hypot(0.5 * body.length_m, 0.5 * body.width_m);
  const double wide = 0.5 * body.width_m + half_diagonal + keep_clear_m;
  std::optional<Meeting> first;
  double first_s = rule.time_s;
  for (const Neighbour& robot : seen.robots) {
    const Point apart = robot.p_WB - seen.p_WB;
    if (std::abs(wrapped(angle_of(apart) - seen.yaw_WB_rad - wanted.bearing_rad)) > rule.ahead_rad) continue;
    const Point theirs = robot.speed_mps * direction(robot.yaw_WB_rad);
    const bool stands = std::abs(robot.speed_mps) < rule.standing_mps;
    if (!stands && theirs.dot(driving) > rule.oncoming_cosine * std::abs(robot.speed_mps)) continue;
    const Point closing = wanted.speed_mps * driving - theirs;
    const double passes = cross(closing, apart) / closing.norm();
    if (std::abs(passes) > wide) continue;
    const double in_s = apart.dot(closing) / closing.squaredNorm();
    if (in_s < 0.0 || in_s >= first_s) continue;
    first_s = in_s;
    first = Meeting{robot, passes};
  }
  return first;
}

}  // namespace caravan::agent
