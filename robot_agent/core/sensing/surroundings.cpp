// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot_agent/core/angle.hpp"

namespace caravan::agent {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kOutermostFrontSonar = 50.0 * std::numbers::pi / 180.0;  // by the robot model

struct Axis {
  Point p_B;
  Point along;
};
std::array<Axis, kSonarCount> make_axes() {
  std::array<Axis, kSonarCount> axes;
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const robot_model::SonarMount& mount = robot_model::kSonarMounts[i];
    axes[i] = {{mount.x_m, mount.y_m}, direction(mount.heading_rad)};
  }
  return axes;
}
const std::array<Axis, kSonarCount>& axes() {
  static const std::array<Axis, kSonarCount> all = make_axes();
  return all;
}

/// Smallest distance along the line of a strip at which the segment from `a` to `b` is inside the strip; +inf
/// if it never is, or ends at `beyond_m` or before. Coordinates: (along the line, across it).
double enters_strip_m(const Point& a, const Point& b, double half_width_m, double beyond_m) {
  double first = 0.0;
  double last = 1.0;
  const double across = b.y() - a.y();
  if (std::abs(across) < 1e-12) {
    if (std::abs(a.y()) > half_width_m) return kInfinity;
  } else {
    const double one = (-half_width_m - a.y()) / across;
    const double other = (half_width_m - a.y()) / across;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
    if (first > last) return kInfinity;
  }
  const double from = a.x() + first * (b.x() - a.x());
  const double to = a.x() + last * (b.x() - a.x());
  if (std::max(from, to) <= beyond_m) return kInfinity;
  return std::max(0.0, std::min(from, to));
}

}  // namespace

Surroundings::Surroundings(const Sensors& sensors, const Sonars& sonars)
    : fan_rad_{kOutermostFrontSonar + 0.5 * sonars.aperture_rad},
      cone_per_metre_{std::tan(0.5 * sonars.aperture_rad)} {
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const double range = sensors.sonar_range_m[i];
    if (sensors.sonar_age_s[i] > sonars.longest_age_s) continue;
    if (i < 8 && !std::isnan(range)) blind_ = false;
    if (!(range >= 0.0 && range < sonars.range_m)) continue;
    const Axis& axis = axes()[i];
    echoes_[count_++] = {axis.p_B + range * axis.along, {-axis.along.y(), axis.along.x()}, range, i};
  }
}

double Surroundings::clearance_m(const Corridor& corridor) const {
  const Point along = direction(corridor.bearing_rad);
  double nearest = kInfinity;
  for (std::size_t i = 0; i < count_; ++i) {
    const Echo& echo = echoes_[i];
    const Point reach = (corridor.surface_m + corridor.surface_per_metre * echo.range_m) * echo.across_B;
    const Point left = echo.p_B + reach;
    const Point right = echo.p_B - reach;
    nearest = std::min(nearest, enters_strip_m({along.dot(left), cross(along, left)},
                                               {along.dot(right), cross(along, right)}, corridor.half_width_m,
                                               corridor.beyond_m));
  }
  for (const Point& place : touched_B_) {
    const double ahead = along.dot(place);
    if (ahead <= corridor.beyond_m) continue;
    if (std::abs(cross(along, place)) > corridor.half_width_m + margin_m_) continue;
    nearest = std::min(nearest, std::max(0.0, ahead - margin_m_));
  }
  return nearest;
}

bool Surroundings::in_front_fan(double bearing_rad) const {
  return std::abs(wrapped(bearing_rad)) <= fan_rad_;
}

}  // namespace caravan::agent
