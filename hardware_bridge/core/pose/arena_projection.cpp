// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/pose/arena_projection.hpp"

#include "runtime/pure/assert.hpp"

namespace caravan::bridge {
namespace {

// WGS 84: semi-major axis and first eccentricity squared.
constexpr double kA_m = 6378137.0;
constexpr double kE2 = 6.69437999014e-3;
constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

ArenaProjection::ArenaProjection(const ArenaPlace& place)
    : place_{place}, cos_{std::cos(place.x_axis_rad)}, sin_{std::sin(place.x_axis_rad)} {
  CARAVAN_ASSERT(std::abs(place.latitude_deg) <= 89.0);
  const double sine = std::sin(place.latitude_deg * kDegree);
  const double w2 = 1.0 - kE2 * sine * sine;
  metres_per_latitude_rad_ = kA_m * (1.0 - kE2) / (w2 * std::sqrt(w2));
  metres_per_longitude_rad_ = kA_m / std::sqrt(w2) * std::cos(place.latitude_deg * kDegree);
}

Point ArenaProjection::to_arena(double latitude_deg, double longitude_deg) const {
  const double north = (latitude_deg - place_.latitude_deg) * kDegree * metres_per_latitude_rad_;
  const double apart_deg = std::remainder(longitude_deg - place_.longitude_deg, 360.0);
  const double east = apart_deg * kDegree * metres_per_longitude_rad_;
  return {cos_ * east + sin_ * north, -sin_ * east + cos_ * north};
}

ArenaProjection::Geodetic ArenaProjection::to_earth(const Point& p_W) const {
  const double east = cos_ * p_W.x_m - sin_ * p_W.y_m;
  const double north = sin_ * p_W.x_m + cos_ * p_W.y_m;
  return {place_.latitude_deg + north / metres_per_latitude_rad_ / kDegree,
          std::remainder(place_.longitude_deg + east / metres_per_longitude_rad_ / kDegree, 360.0)};
}

double ArenaProjection::yaw_of_bearing(double bearing_rad) const {
  return wrapped(0.5 * std::numbers::pi - bearing_rad - place_.x_axis_rad);
}

double ArenaProjection::bearing_of_yaw(double yaw_W_rad) const {
  const double bearing = wrapped(0.5 * std::numbers::pi - yaw_W_rad - place_.x_axis_rad);
  return bearing < 0.0 ? bearing + 2.0 * std::numbers::pi : bearing;
}

}  // namespace caravan::bridge
