// SPDX-License-Identifier: Apache-2.0
#include "tests/support/sonar_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot_agent/core/angle.hpp"

namespace caravan::test {
namespace {

using agent::cross;
using agent::direction;
using agent::Point;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kReflection = 0.92387953251128674;  // cosine of 22.5 degrees

/// A ray meets a wall.
struct Hit {
  double distance_m = kInfinity;
  bool reflects = false;
};

/// The nearest wall that a ray meets within `range_m`.
Hit nearest_hit(std::span<const Wall> walls, const Point& from, const Point& along, double range_m) {
  double nearest = range_m;
  const Wall* met = nullptr;
  for (const Wall& wall : walls) {
    const Point a = wall.a - from;
    const Point b = wall.b - from;
    const double left = cross(along, a);
    const double right = cross(along, b);
    if ((left > 0.0) == (right > 0.0)) continue;
    const double share = left / (left - right);
    const double distance = along.dot(a + share * (b - a));
    if (distance < 0.0 || distance >= nearest) continue;
    nearest = distance;
    met = &wall;
  }
  if (met == nullptr) return {};
  const Point side = met->b - met->a;
  return {nearest, std::abs(cross(along, side)) > kReflection * side.norm()};
}

double range(std::span<const Wall> walls, const Point& from, double heading_rad, double range_m) {
  double nearest = kInfinity;
  for (const double aside : {-0.2, 0.0, 0.2}) {
    const Hit hit = nearest_hit(walls, from, direction(heading_rad + aside), range_m);
    if (hit.reflects) nearest = std::min(nearest, hit.distance_m);
  }
  return nearest;
}

}  // namespace

std::vector<Wall> rectangle(const Point& centre, double width_m, double height_m, double yaw_rad) {
  const Point x = 0.5 * width_m * direction(yaw_rad);
  const Point y = 0.5 * height_m * direction(yaw_rad + 0.5 * std::numbers::pi);
  const std::array<Point, 4> corners = {centre + x + y, centre - x + y, centre - x - y, centre + x - y};
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < 4; ++i) walls.push_back({corners[i], corners[(i + 1) % 4]});
  return walls;
}

std::array<double, agent::kSonarCount> sonar_ranges_m(std::span<const Wall> walls, const Point& p_WB,
                                                      double yaw_WB_rad, double range_m) {
  const Point ahead = direction(yaw_WB_rad);
  const Point left{-ahead.y(), ahead.x()};
  std::array<double, agent::kSonarCount> ranges{};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const robot_model::SonarMount& mount = robot_model::kSonarMounts[i];
    ranges[i] =
        range(walls, p_WB + mount.x_m * ahead + mount.y_m * left, yaw_WB_rad + mount.heading_rad, range_m);
  }
  return ranges;
}

agent::Perception look(std::span<const Wall> walls, const Point& p_WB, double yaw_WB_rad) {
  agent::Sensors sensors;
  sensors.sonar_range_m = sonar_ranges_m(walls, p_WB, yaw_WB_rad);
  sensors.p_WB = p_WB;
  sensors.yaw_WB_rad = yaw_WB_rad;
  return agent::perceive(agent::Time{0}, sensors, false, {}, {}, {}, {});
}

}  // namespace caravan::test
