// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Where on earth the arena lies.
struct ArenaPlace {
  double latitude_deg = 0.0;  ///< of W's origin, WGS 84
  double longitude_deg = 0.0;
  double x_axis_rad = 0.0;  ///< W's x axis, counter-clockwise from east
};

/// Between latitude and longitude and frame W: the plane that touches the ellipsoid at W's origin.
///
/// Good to a millimetre within 200 m of it at the latitudes people live in (ArenaProjection tests); poles
/// excluded.
class ArenaProjection {
 public:
  /// @pre the latitude is within +-89 degrees
  explicit ArenaProjection(const ArenaPlace& place);

  [[nodiscard]] Point to_arena(double latitude_deg, double longitude_deg) const;
  struct Geodetic {
    double latitude_deg = 0.0;
    double longitude_deg = 0.0;
  };
  [[nodiscard]] Geodetic to_earth(const Point& p_W) const;

  /// A direction clockwise from north as a yaw in W, in (-pi, pi].
  [[nodiscard]] double yaw_of_bearing(double bearing_rad) const;
  /// In [0, 2 pi).
  [[nodiscard]] double bearing_of_yaw(double yaw_W_rad) const;

 private:
  ArenaPlace place_;
  double metres_per_latitude_rad_;
  double metres_per_longitude_rad_;
  double cos_, sin_;
};

}  // namespace caravan::bridge
