// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/pure/random.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/sensors/sonar.hpp"

/// The sonars against two oracles: every ray against every surface, and ODE's rays against ODE's bodies.
namespace caravan::world {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();

struct Scene {
  WorldConfig config;
  std::vector<Pose> poses;
};

Outline random_outline(pure::Random& random, Point centre) {
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

/// Solids of all kinds and heights, robots anywhere, even inside them.
Scene random_scene(std::uint64_t seed, bool with_outlines) {
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

Solid body_of(const WorldConfig& config, const Pose& pose) {
  const double cosine = std::cos(pose.yaw_rad);
  const double sine = std::sin(pose.yaw_rad);
  const Point middle = placed({config.robots.body_ahead_m - 0.5 * config.robots.body_length_m, 0.0},
                              {pose.x_m, pose.y_m}, cosine, sine);
  return to_solid(Box{.centre_m = {middle.x, middle.y},
                      .size_m = {config.robots.body_length_m, config.robots.body_width_m},
                      .yaw_rad = pose.yaw_rad,
                      .height_m = config.robots.body_height_m});
}

std::vector<Solid> solids_around(const Scene& scene, std::size_t robot) {
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

/// The side of a prism from p to q.
Meeting meet_side(Point p, Point q, double height, Point from, const Ray& ray) {
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

Meeting meet_disc(const Solid& solid, Point from, const Ray& ray) {
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

/// The nearest surface along a ray, among all there are.
Meeting nearest(const std::vector<Solid>& solids, Point from, const Ray& ray) {
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

Point turned(Point a, double angle) { return placed(a, {}, std::cos(angle), std::sin(angle)); }

/// Calls visit(transducer, place, world ray) for every ray of a robot.
template <typename Visit>
void for_each_ray(const Scene& scene, const Pose& pose, Visit visit) {
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const SonarMount& mount = sonar_mounts()[i];
    const Point from =
        placed(mount.place, {pose.x_m, pose.y_m}, std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
    for (const Ray& ray : sonar_rays(scene.config.robots.sonar)) {
      visit(i, from, Ray{turned(ray.flat, pose.yaw_rad + mount.heading_rad), ray.up});
    }
  }
}

std::array<double, kSonarCount> brute_force(const Scene& scene, std::size_t robot) {
  const auto solids = solids_around(scene, robot);
  const auto& sonar = scene.config.robots.sonar;
  std::array<double, kSonarCount> ranges{};
  ranges.fill(kNoEcho);
  for_each_ray(scene, scene.poses[robot], [&](std::size_t i, Point from, const Ray& ray) {
    for (const Solid& solid : solids) {
      if (solid.height >= kSonarHeight && contains(solid, from)) ranges[i] = 0.0;
    }
    const Meeting meeting = nearest(solids, from, ray);
    const bool echoes = meeting.cosine > std::cos(sonar.reflection_rad) && meeting.distance <= sonar.range_m;
    if (echoes) ranges[i] = std::min(ranges[i], meeting.distance);
  });
  return ranges;
}

TEST(SonarProperty, EqualsEveryRayAgainstEverySurface) {
  std::size_t echoes = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed, true);
    Sonars sonars{scene.config};
    sonars.place(scene.poses);
    for (std::size_t robot = 0; robot < scene.poses.size(); ++robot) {
      const auto ranges = sonars.ranges(robot);
      const auto expected = brute_force(scene, robot);
      for (std::size_t i = 0; i < kSonarCount; ++i) {
        if (std::isinf(expected[i])) {
          ASSERT_EQ(ranges[i], expected[i]) << "robot " << robot << " sonar " << i;
        } else {
          ASSERT_NEAR(ranges[i], expected[i], 1e-9) << "robot " << robot << " sonar " << i;
          echoes += expected[i] > 0.0 ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_GT(echoes, 5000U);
}

/// ODE's bodies for the same scene, and its answer for one ray.
class OdeScene {
 public:
  OdeScene(const Scene& scene, std::size_t robot) {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    geoms_.push_back(dCreatePlane(nullptr, 0, 0, 1, 0));
    for (const Box& box : arena_walls(scene.config.arena_m, scene.config.wall_height_m)) add(box);
    for (const Box& box : scene.config.boxes) add(box);
    for (const Cylinder& cylinder : scene.config.cylinders) add(cylinder);
    for (std::size_t other = 0; other < scene.poses.size(); ++other) {
      if (other == robot) continue;
      const Solid body = body_of(scene.config, scene.poses[other]);
      const Point middle = 0.5 * (body.outline[0] + body.outline[2]);
      add(Box{.centre_m = {middle.x, middle.y},
              .size_m = {scene.config.robots.body_length_m, scene.config.robots.body_width_m},
              .yaw_rad = scene.poses[other].yaw_rad,
              .height_m = body.height});
    }
    ray_ = dCreateRay(nullptr, 100.0);
  }
  ~OdeScene() {
    for (const dGeomID geom : geoms_) dGeomDestroy(geom);
    dGeomDestroy(ray_);
  }
  OdeScene(const OdeScene&) = delete;
  OdeScene& operator=(const OdeScene&) = delete;

  [[nodiscard]] Meeting cast(Point from, const Ray& ray) const {
    dGeomRaySet(ray_, from.x, from.y, kSonarHeight, ray.flat.x, ray.flat.y, ray.up);
    Meeting best;
    for (const dGeomID geom : geoms_) {
      dContactGeom contact;
      if (dCollide(ray_, geom, 1, &contact, sizeof contact) == 0 || contact.depth >= best.distance) continue;
      const double along =
          ray.flat.x * contact.normal[0] + ray.flat.y * contact.normal[1] + ray.up * contact.normal[2];
      best = {contact.depth, -along};
    }
    return best;
  }

 private:
  void add(const Box& box) {
    const dGeomID geom = dCreateBox(nullptr, box.size_m[0], box.size_m[1], box.height_m);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, 0, 1, box.yaw_rad);
    dGeomSetRotation(geom, rotation);
    dGeomSetPosition(geom, box.centre_m[0], box.centre_m[1], 0.5 * box.height_m);
    geoms_.push_back(geom);
  }
  void add(const Cylinder& cylinder) {
    const dGeomID geom = dCreateCylinder(nullptr, cylinder.radius_m, cylinder.height_m);
    dGeomSetPosition(geom, cylinder.centre_m[0], cylinder.centre_m[1], 0.5 * cylinder.height_m);
    geoms_.push_back(geom);
  }

  std::vector<dGeomID> geoms_;
  dGeomID ray_ = nullptr;
};

TEST(SonarProperty, AgreesWithTheRaysOfTheRigidBodyLibrary) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed, false);
    for (std::size_t robot = 0; robot < 2; ++robot) {
      const auto solids = solids_around(scene, robot);
      const OdeScene ode{scene, robot};
      for_each_ray(scene, scene.poses[robot], [&](std::size_t, Point from, const Ray& ray) {
        for (const Solid& solid : solids) {
          if (contains(solid, from)) return;  // ODE's rays see surfaces from inside
        }
        const Meeting ours = nearest(solids, from, ray);
        const Meeting theirs = ode.cast(from, ray);
        if (std::isinf(ours.distance) && std::isinf(theirs.distance)) return;
        ASSERT_NEAR(ours.distance, theirs.distance, 1e-6);
        ASSERT_NEAR(ours.cosine, theirs.cosine, 1e-6);
        ++compared;
      });
    }
  }
  EXPECT_GT(compared, 5000U);
}

}  // namespace
}  // namespace caravan::world
