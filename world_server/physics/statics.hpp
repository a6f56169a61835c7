// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include <vector>

#include "world_server/config/world_config.hpp"
#include "world_server/shapes/reach_map.hpp"

namespace caravan::world {

/// Everything that does not move: walls, boxes, outlines as rings of boxes, cylinders, and the floor.
class Statics {
 public:
  /// @param reach  distance from `place` at which a robot may touch something before the next near(), metres
  Statics(const WorldConfig& config, double reach);
  ~Statics();
  Statics(const Statics&) = delete;
  Statics& operator=(const Statics&) = delete;

  /// Calls `visit(geom)` for each thing that a disc of `radius` at `place` may touch, always in the same
  /// order.
  template <typename Visit>
  void near(Point place, double radius, Visit visit) const {
    for (const std::uint32_t i : map_->near(place)) {
      if (is_within(things_[i], place, radius)) visit(things_[i].geom);
    }
  }
  [[nodiscard]] dGeomID floor() const { return floor_; }

 private:
  struct Thing {
    dGeomID geom = nullptr;
    Point centre;
    Point along{1.0, 0.0};  // unit
    Point half;             // of a box
    double radius = 0.0;    // of a cylinder; 0: a box
  };
  [[nodiscard]] static bool is_within(const Thing& thing, Point place, double radius);
  void add(const Box& box);
  void add(const Cylinder& cylinder);

  std::vector<Thing> things_;
  std::vector<Extent> extents_;
  std::unique_ptr<ReachMap> map_;
  dGeomID floor_ = nullptr;
};

}  // namespace caravan::world
