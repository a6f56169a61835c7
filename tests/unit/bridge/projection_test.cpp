// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "hardware_bridge/core/pose/arena_projection.hpp"

namespace caravan::bridge {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Tabulated lengths of a degree at 0, 45 and 60 degrees of latitude on WGS 84.
struct DegreeLengths {
  double latitude_deg, of_latitude_m, of_longitude_m;
};
constexpr DegreeLengths kTable[] = {
    {0.0, 110574.0, 111320.0}, {45.0, 111132.0, 78847.0}, {60.0, 111412.0, 55800.0}};

TEST(ArenaProjection, ADegreeIsAsLongAsTheTablesSay) {
  for (const DegreeLengths& row : kTable) {
    const ArenaProjection projection{{row.latitude_deg, 10.0, 0.0}};
    EXPECT_NEAR(1000.0 * projection.to_arena(row.latitude_deg + 0.001, 10.0).y_m, row.of_latitude_m, 1.5);
    EXPECT_NEAR(1000.0 * projection.to_arena(row.latitude_deg, 10.001).x_m, row.of_longitude_m, 1.5);
  }
}

/// East and north of the origin, computed in earth-centred coordinates: not approximated by radii of
/// curvature.
Point tangent_plane(double latitude_deg, double longitude_deg, const ArenaPlace& origin) {
  constexpr double kA = 6378137.0;
  constexpr double kE2 = 6.69437999014e-3;
  const auto earth = [](double lat, double lon) {
    const double n = kA / std::sqrt(1.0 - kE2 * std::sin(lat) * std::sin(lat));
    return std::array{n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon),
                      n * (1.0 - kE2) * std::sin(lat)};
  };
  const double lat = origin.latitude_deg * kDegree;
  const double lon = origin.longitude_deg * kDegree;
  const auto p = earth(latitude_deg * kDegree, longitude_deg * kDegree);
  const auto o = earth(lat, lon);
  const std::array d{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
  return {
      -std::sin(lon) * d[0] + std::cos(lon) * d[1],
      -std::sin(lat) * std::cos(lon) * d[0] - std::sin(lat) * std::sin(lon) * d[1] + std::cos(lat) * d[2]};
}

TEST(ArenaProjection, IsTheTangentPlaneToAFewMillimetresWithin200m) {
  for (const double latitude : {0.0, 33.0, 48.0, -55.0}) {
    const ArenaPlace place{latitude, 7.0, 0.0};
    const ArenaProjection projection{place};
    for (const Point p : {Point{200.0, 0.0}, Point{-140.0, 140.0}, Point{100.0, -170.0}, Point{25.0, 25.0}}) {
      const auto earth = projection.to_earth(p);
      const Point plane = tangent_plane(earth.latitude_deg, earth.longitude_deg, place);
      EXPECT_NEAR(plane.x_m, p.x_m, 0.006) << latitude;
      EXPECT_NEAR(plane.y_m, p.y_m, 0.006) << latitude;
    }
  }
}

TEST(ArenaProjection, ThereAndBackIsTheSamePointForATurnedArenaAcrossTheDateLine) {
  const ArenaProjection projection{{-17.0, 179.9999, 0.7}};
  for (const Point p : {Point{24.0, -3.0}, Point{-24.0, 11.0}}) {
    const auto earth = projection.to_earth(p);
    const Point again = projection.to_arena(earth.latitude_deg, earth.longitude_deg);
    EXPECT_NEAR(again.x_m, p.x_m, 1e-6);
    EXPECT_NEAR(again.y_m, p.y_m, 1e-6);
  }
}

TEST(ArenaProjection, ATurnedArenasXAxisPointsWhereItWasTurned) {
  const ArenaProjection projection{{0.0, 0.0, 0.5 * std::numbers::pi}};
  const Point north = projection.to_arena(0.0001, 0.0);
  EXPECT_GT(north.x_m, 11.0);
  EXPECT_NEAR(north.y_m, 0.0, 1e-9);
}

TEST(ArenaProjection, BearingsAreClockwiseFromNorth) {
  const ArenaProjection straight{{}};
  EXPECT_NEAR(straight.yaw_of_bearing(0.0), 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(straight.yaw_of_bearing(90.0 * kDegree), 0.0, 1e-12);
  EXPECT_NEAR(straight.yaw_of_bearing(270.0 * kDegree), std::numbers::pi, 1e-12);
  const ArenaProjection turned{{10.0, 20.0, 0.3}};
  for (const double yaw : {-3.0, -1.0, 0.0, 2.0, 3.1}) {
    EXPECT_NEAR(turned.yaw_of_bearing(turned.bearing_of_yaw(yaw)), yaw, 1e-12);
  }
}

}  // namespace
}  // namespace caravan::bridge
