// SPDX-License-Identifier: Apache-2.0
#include "world_server/starts/room.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "world_server/shapes/scene.hpp"

namespace caravan::world {

std::string obstacle_at(const WorldConfig& config, std::span<const Pose> poses, std::uint32_t robot,
                        const Pose& place) {
  const double reach = body_radius_m(config.robots);
  const Point point{place.x_m, place.y_m};
  if (std::abs(point.x) > 0.5 * config.arena_m[0] - reach ||
      std::abs(point.y) > 0.5 * config.arena_m[1] - reach)
    return "a wall of the arena is there";
  std::vector<Solid> solids;
  for (const Box& box : config.boxes) solids.push_back(to_solid(box));
  for (const Cylinder& cylinder : config.cylinders) solids.push_back(to_solid(cylinder));
  for (const Outline& outline : config.outlines) solids.push_back(to_solid(outline));
  if (std::any_of(solids.begin(), solids.end(),
                  [&](const Solid& solid) { return distance_to(solid, point) < reach; }))
    return "something solid is there";
  for (std::uint32_t other = 1; other <= poses.size(); ++other) {
    const Point there{poses[other - 1].x_m, poses[other - 1].y_m};
    if (other != robot && length(there - point) < 2.0 * reach)
      return "robot " + std::to_string(other) + " is there";
  }
  return "";
}

}  // namespace caravan::world
