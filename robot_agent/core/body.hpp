// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A robot's body: a rectangle on the floor.
struct Body {
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
};

/// Distance between the outlines of two bodies, metres; 0 when they touch or overlap.
[[nodiscard]] double distance_m(const Body& one, const Body& other, const Config& config);

/// Distance of a point from the body's outline; 0 inside.
[[nodiscard]] double distance_m(const Body& body, const Point& p_W, const Config& config);
/// The same; inside the outline how deep, negative.
[[nodiscard]] double signed_distance_m(const Body& body, const Point& p_W, const Config& config);

}  // namespace caravan::agent
