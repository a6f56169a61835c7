// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "tests/unit/world/scenes.hpp"

namespace caravan::world {
namespace {

/// The same scene as ODE bodies, and the answer of ODE for one ray.
class OdeScene {
 public:
  OdeScene(const Scene& scene, std::size_t robot) {
    dInitODE2(0);
    dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
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
          if (contains(solid, from)) return;  // ODE also reports surfaces seen from inside
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
