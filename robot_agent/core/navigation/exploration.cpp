// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/exploration.hpp"

#include <algorithm>
#include <numbers>

namespace caravan::agent {
Point new_location_to_explore(const Perception& seen, const Exploration& exploration, const Passage& passage,
                              const Body& body, pure::Random& random) {
  const double wanted = exploration.step_m + body.ahead_m + exploration.turn_room_m;
  double spread = exploration.spread_rad;
  double best_bearing = 0.0;
  double best_clearance = -1.0;
  for (std::uint32_t draw = 0; draw < exploration.draws; ++draw) {
    const double bearing = random.uniform(-spread, spread);
    const double clearance = seen.around.clearance_m({.bearing_rad = bearing,
                                                      .half_width_m = 0.5 * passage.corridor_m,
                                                      .surface_m = passage.surface_m,
                                                      .surface_per_metre = passage.surface_per_metre});
    if (clearance > best_clearance) {
      best_clearance = clearance;
      best_bearing = bearing;
    }
    if (clearance >= wanted) break;
    spread = std::min(spread * exploration.widening, std::numbers::pi);
  }
  return seen.p_WB + exploration.step_m * direction(seen.yaw_WB_rad + best_bearing);
}

}  // namespace caravan::agent
