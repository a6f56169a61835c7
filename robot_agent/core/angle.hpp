// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "robot_agent/core/types.hpp"
#include "runtime/pure/angle.hpp"

namespace caravan::agent {

using pure::wrapped;

/// The unit vector at an angle, counter-clockwise from the frame's x axis.
[[nodiscard]] inline Point direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

/// The angle of a vector, counter-clockwise from the frame's x axis; 0 for the null vector.
[[nodiscard]] inline double angle_of(const Point& vector) { return std::atan2(vector.y(), vector.x()); }

/// Third component of the cross product: positive when `b` lies to the left of `a`.
[[nodiscard]] inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace caravan::agent
