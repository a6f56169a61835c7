// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "runtime/pure/random.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/sensors/sonar.hpp"

/// Random scenes, and a test oracle for the sonars that intersects each ray with every surface.
namespace caravan::world {
inline constexpr double kNoEcho = std::numeric_limits<double>::infinity();

struct Scene {
  WorldConfig config;
  std::vector<Pose> poses;
};

inline Outline random_outline(pure::Random& random, Point centre) {
  Outline outline;
  outline.height_m = random.uniform(0.1, 1.5);
  const int count = static_cast<int>(random.uniform(3.0, 9.0));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.6)) / count;
    const double radius = random.uniform(0.4, 2.0);
    outline.points_m.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return outline;
}

/// Solids of all kinds and heights, and robots anywhere, even inside solids.
inline Scene random_scene(std::uint64_t seed, bool with_outlines) {
  pure::Random random{seed};
  Scene scene{empty_world(16.0, 8), {}};
  auto& sonar = scene.config.robots.sonar;
  sonar.rays = static_cast<std::uint32_t>(random.uniform(1.0, 33.0));
  sonar.aperture_rad = random.uniform(0.05, 1.4);
  sonar.reflection_rad = random.uniform(0.1, 1.5);
  sonar.range_m = random.uniform(1.0, 6.0);
  scene.config.robots.body_height_m = random.uniform(0.15, 0.4);
  const auto place = [&] { return std::array{random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)}; };
  for (int i = 0; i < 4; ++i) {
    scene.config.boxes.push_back({.centre_m = place(),
                                  .size_m = {random.uniform(0.3, 2.0), random.uniform(0.3, 2.0)},
                                  .yaw_rad = random.uniform(-3.0, 3.0),
                                  .height_m = random.uniform(0.1, 1.5)});
    scene.config.cylinders.push_back(
        {.centre_m = place(), .radius_m = random.uniform(0.1, 1.0), .height_m = random.uniform(0.1, 1.5)});
    if (with_outlines) scene.config.outlines.push_back(random_outline(random, to_point(place())));
  }
  for (int i = 0; i < 8; ++i) {
    const auto at = place();
    scene.poses.push_back({at[0], at[1], random.uniform(-3.14, 3.14)});
  }
  return scene;
}

inline Solid body_of(const WorldConfig& config, const Pose& pose) {
  const double cosine = std::cos(pose.yaw_rad);
  const double sine = std::sin(pose.yaw_rad);
  const Point middle = placed({config.robots.body_ahead_m - 0.5 * config.robots.body_length_m, 0.0},
                              {pose.x_m, pose.y_m}, cosine, sine);
  return to_solid(Box{.centre_m = {middle.x, middle.y},
                      .size_m = {config.robots.body_length_m, config.robots.body_width_m},
                      .yaw_rad = pose.yaw_rad,
                      .height_m = config.robots.body_height_m});
}

inline std::vector<Solid> solids_around(const Scene& scene, std::size_t robot) {
  std::vector<Solid> solids;
  for (const Box& wall : arena_walls(scene.config.arena_m, scene.config.wall_height_m)) {
    solids.push_back(to_solid(wall));
  }
  for (const Box& box : scene.config.boxes) solids.push_back(to_solid(box));
  for (const Cylinder& cylinder : scene.config.cylinders) solids.push_back(to_solid(cylinder));
  for (const Outline& outline : scene.config.outlines) solids.push_back(to_solid(outline));
  for (std::size_t other = 0; other < scene.poses.size(); ++other) {
    if (other != robot) solids.push_back(body_of(scene.config, scene.poses[other]));
  }
  return solids;
}

struct Meeting {
  double distance = kNoEcho;
  double cosine = -1.0;
};

/// The intersection of a ray with the side of a prism from p to q.
inline Meeting meet_side(Point p, Point q, double height, Point from, const Ray& ray) {
  const Point side = q - p;
  const double inwards = cross(side, ray.flat) / length(side);
  if (inwards <= 0.0) return {};
  const double det = cross(ray.flat, side);
  const double distance = cross(p - from, side) / det;
  const double share = cross(p - from, ray.flat) / det;
  const double z = kSonarHeight + distance * ray.up;
  if (distance < 0.0 || share < 0.0 || share > 1.0 || z > height) return {};
  return {distance, inwards};
}

inline Meeting meet_disc(const Solid& solid, Point from, const Ray& ray) {
  const double a = dot(ray.flat, ray.flat);
  const double b = 2.0 * dot(ray.flat, from - solid.centre);
  const double c = dot(from - solid.centre, from - solid.centre) - solid.radius * solid.radius;
  const double inside = b * b - 4.0 * a * c;
  if (inside < 0.0) return {};
  const double distance = (-b - std::sqrt(inside)) / (2.0 * a);
  if (distance < 0.0 || kSonarHeight + distance * ray.up > solid.height) return {};
  const Point outwards = (1.0 / solid.radius) * (from + distance * ray.flat - solid.centre);
  return {distance, -dot(outwards, ray.flat)};
}

/// The intersection of a ray with the nearest of all surfaces.
inline Meeting nearest(const std::vector<Solid>& solids, Point from, const Ray& ray) {
  Meeting best;
  const auto keep = [&](Meeting one) {
    if (one.distance < best.distance) best = one;
  };
  if (ray.up < 0.0) keep({kSonarHeight / -ray.up, -ray.up});
  for (const Solid& solid : solids) {
    if (ray.up < 0.0 && solid.height < kSonarHeight) {
      const double down = (solid.height - kSonarHeight) / ray.up;
      if (contains(solid, from + down * ray.flat)) keep({down, -ray.up});
    }
    if (solid.outline.empty()) keep(meet_disc(solid, from, ray));
    for (std::size_t i = 0; i < solid.outline.size(); ++i) {
      keep(meet_side(solid.outline[i], solid.outline[(i + 1) % solid.outline.size()], solid.height, from,
                     ray));
    }
  }
  return best;
}

inline Point turned(Point a, double angle) { return placed(a, {}, std::cos(angle), std::sin(angle)); }

/// Calls visit(sonar, position, ray), both in frame W, for every ray of a robot.
template <typename Visit>
void for_each_ray(const Scene& scene, const Pose& pose, Visit visit) {
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const robot_model::SonarMount& mount = robot_model::kSonarMounts[i];
    const Point from =
        placed({mount.x_m, mount.y_m}, {pose.x_m, pose.y_m}, std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
    for (const Ray& ray : sonar_rays(scene.config.robots.sonar)) {
      visit(i, from, Ray{turned(ray.flat, pose.yaw_rad + mount.heading_rad), ray.up});
    }
  }
}

}  // namespace caravan::world
