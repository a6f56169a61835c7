// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/types.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::agent {

/// Outline of a robot on the floor, a rectangle, and its wheels.
struct Body {
  double length_m = robot_model::kBodyLength_m;
  double ahead_m = robot_model::kBodyAhead_m;  ///< from the axle to the front
  double width_m = robot_model::kBodyWidth_m;
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
  double wheel_limit_mps = robot_model::kWheelLimit_mps;  ///< rim speed
  double side_margin_m = 0.04;                            ///< free space required on each side

  bool operator==(const Body&) const = default;
};

/// Pose of a robot's base, the middle of its axle, in frame W.
struct Pose {
  Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
};

/// Distance between the outlines of two robots with the same body, metres; 0 when they touch or overlap.
[[nodiscard]] double distance_m(const Pose& one, const Pose& other, const Body& body);

/// Distance of a point from a robot's outline; 0 inside.
[[nodiscard]] double distance_m(const Pose& pose, const Point& p_W, const Body& body);
/// Like distance_m(), but negative inside the outline: the depth.
[[nodiscard]] double signed_distance_m(const Pose& pose, const Point& p_W, const Body& body);

}  // namespace caravan::agent
