// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/arrival.hpp"

#include "robot_agent/core/navigation/steering.hpp"

namespace caravan::agent {
bool has_arrived(const Perception& seen, const Point& at, const Task& task, const Body& body) {
  const double distance = seen.distance_to(at);
  if (distance < task.arrival_radius_m) return true;
  if (distance >= task.service_radius_m || !seen.robot_near) return false;
  return free_ahead_m(seen.around, body, seen.bearing_to(at)) < task.crowded_m;
}

}  // namespace caravan::agent
