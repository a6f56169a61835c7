// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// The arena's place on earth.
struct ArenaPlace {
  double latitude_deg = 0.0;  ///< latitude of W's origin, WGS 84
  double longitude_deg = 0.0;
  double x_axis_rad = 0.0;  ///< direction of W's x axis, counter-clockwise from east
};

/// Converts between latitude and longitude and frame W, by the tangent plane of the ellipsoid at W's origin.
///
/// Accurate to a millimetre within 200 m of the origin at inhabited latitudes (ArenaProjection tests); not
/// for the poles.
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

  /// The yaw in W of a bearing clockwise from north, in (-pi, pi].
  [[nodiscard]] double yaw_of_bearing(double bearing_rad) const;
  /// The bearing clockwise from north of a yaw in W, in [0, 2 pi).
  [[nodiscard]] double bearing_of_yaw(double yaw_W_rad) const;

 private:
  ArenaPlace place_;
  double metres_per_latitude_rad_;
  double metres_per_longitude_rad_;
  double cos_, sin_;
};

}  // namespace caravan::bridge
