// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/statics.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "world_server/physics/ode_session.hpp"

namespace caravan::world {

Statics::Statics(const WorldConfig& config, double reach) {
  OdeSession::prepare_thread();
  floor_ = dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0);
  for (const Box& wall : arena_walls(config.arena_m, config.wall_height_m)) add(wall);
  for (const Box& box : config.boxes) add(box);
  for (const Outline& outline : config.outlines) {
    for (const Box& box : ring_of_boxes(outline)) add(box);
  }
  for (const Cylinder& cylinder : config.cylinders) add(cylinder);
  map_ = std::make_unique<ReachMap>(config.arena_m, extents_, reach);
}

Statics::~Statics() {
  for (const Thing& thing : things_) dGeomDestroy(thing.geom);
  dGeomDestroy(floor_);
}

void Statics::add(const Box& box) {
  Thing thing;
  thing.geom = dCreateBox(nullptr, box.size_m[0], box.size_m[1], box.height_m);
  thing.centre = to_point(box.centre_m);
  thing.along = {std::cos(box.yaw_rad), std::sin(box.yaw_rad)};
  thing.half = {0.5 * box.size_m[0], 0.5 * box.size_m[1]};
  dMatrix3 turned;
  dRFromAxisAndAngle(turned, 0, 0, 1, box.yaw_rad);
  dGeomSetRotation(thing.geom, turned);
  dGeomSetPosition(thing.geom, thing.centre.x, thing.centre.y, 0.5 * box.height_m);
  things_.push_back(thing);
  extents_.push_back(extent_of(to_solid(box)));
}

void Statics::add(const Cylinder& cylinder) {
  Thing thing;
  thing.geom = dCreateCylinder(nullptr, cylinder.radius_m, cylinder.height_m);
  thing.centre = to_point(cylinder.centre_m);
  thing.radius = cylinder.radius_m;
  dGeomSetPosition(thing.geom, thing.centre.x, thing.centre.y, 0.5 * cylinder.height_m);
  things_.push_back(thing);
  extents_.push_back(extent_of(to_solid(cylinder)));
}

bool Statics::is_within(const Thing& thing, Point place, double radius) {
  const Point apart = place - thing.centre;
  if (thing.radius > 0.0) return dot(apart, apart) <= (radius + thing.radius) * (radius + thing.radius);
  const double x = std::max(0.0, std::abs(dot(apart, thing.along)) - thing.half.x);
  const double y = std::max(0.0, std::abs(cross(thing.along, apart)) - thing.half.y);
  return x * x + y * y <= radius * radius;
}

}  // namespace caravan::world
