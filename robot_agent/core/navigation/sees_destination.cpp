// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/sees_destination.hpp"

namespace caravan::agent {

std::optional<Point> sees_destination(const Perception& seen, const Task& task,
                                      const Exploration& exploration, const Passage& passage) {
  const double distance = seen.distance_to(task.destination);
  if (distance > exploration.detection_radius_m) return std::nullopt;
  const Corridor line_of_sight{.bearing_rad = seen.bearing_to(task.destination),
                               .half_width_m = 0.5 * passage.corridor_m,
                               .surface_m = exploration.sight_surface_m,
                               .surface_per_metre = exploration.sight_surface_per_metre};
  if (seen.around.clearance_m(line_of_sight) < distance) return std::nullopt;
  return task.destination;
}

}  // namespace caravan::agent
