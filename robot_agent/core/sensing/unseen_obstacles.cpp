// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/unseen_obstacles.hpp"

#include <algorithm>
#include <array>

namespace caravan::agent {
namespace {

Point turned(const Point& v_B, double yaw_WB_rad) {
  const Point ahead = direction(yaw_WB_rad);
  return v_B.x() * ahead + v_B.y() * Point{-ahead.y(), ahead.x()};
}

std::vector<Point> in_base_frame(const std::vector<Point>& places_W, const Perception& seen) {
  std::vector<Point> result;
  result.reserve(places_W.size());
  for (const Point& place : places_W) result.push_back(turned(place - seen.p_WB, -seen.yaw_WB_rad));
  return result;
}

}  // namespace

bool UnseenObstacles::is_explained(const Touch& touch, const Surfaces& surfaces,
                                   const Perception& seen) const {
  if (seen.robot_near && seen.robots.empty()) return true;
  const Point beside_B{-touch.towards_B.y(), touch.towards_B.x()};
  return std::ranges::any_of(std::array{-1.0, 0.0, 1.0}, [&](double side) {
    const Point at_B = touch.at_B + side * touch.either_side_m * beside_B;
    const Point at_W = seen.p_WB + turned(at_B, seen.yaw_WB_rad);
    const bool robot = std::ranges::any_of(seen.robots, [&](const Neighbour& one) {
      return distance_m(Pose{one.p_WB, one.yaw_WB_rad}, at_W, settings_.body) < settings_.memory.robot_m;
    });
    return robot || surfaces.is_high(at_W);
  });
}

std::optional<Point> UnseenObstacles::feel(const Sensors& sensors, const Wheels& told,
                                           const Surfaces& surfaces, Perception& seen) {
  if (settings_.memory.places == 0) return std::nullopt;
  std::optional<Point> is_new;
  if (const auto touch = sensor_.update(seen.now, sensors, told, settings_.body)) {
    const Point at = seen.p_WB + turned(touch->at_B, seen.yaw_WB_rad);
    seen.touched = !is_explained(*touch, surfaces, seen);
    if (seen.touched && places_.add(at, turned(touch->towards_B, seen.yaw_WB_rad))) is_new = at;
  }
  if (const auto place = expect(surfaces, seen)) is_new = place;
  if (patience_.is_lost(seen)) places_.forget_around(seen.p_WB, patience_.forget_radius_m());
  if (places_.empty()) return is_new;
  places_.forget_if([&](const Point& at) {
    return seen.distance_to(at) < settings_.memory.check_radius_m && surfaces.is_high(at);
  });
  places_.stand_on({seen.p_WB, seen.yaw_WB_rad}, settings_.body);
  for (const Point& at : places_.at(seen.p_WB, surfaces.reach_m())) seen.surfaces.push_back(at);
  seen.touched_W = places_.middles(seen.p_WB, settings_.vision_radius_m);
  const std::vector<Point> middles_B = in_base_frame(seen.touched_W, seen);
  seen.still.add_touched(middles_B, settings_.memory.margin_m);
  seen.around.add_touched(middles_B, settings_.memory.margin_m);
  return is_new;
}

/// The place of an obstacle ahead that is lower than the sonars, if it is new.
std::optional<Point> UnseenObstacles::expect(const Surfaces& surfaces, const Perception& seen) {
  const auto ahead_m = vanishing_.update(seen);
  if (!ahead_m) return std::nullopt;
  const Point ahead = direction(seen.yaw_WB_rad);
  const Point at = seen.p_WB + *ahead_m * ahead;
  if (surfaces.is_high(at) || !places_.add(at, ahead)) return std::nullopt;
  return at;
}

std::optional<Point> UnseenObstacles::touch_ahead(const Surfaces& surfaces, const Perception& seen) {
  if (settings_.memory.places == 0) return std::nullopt;
  const Touch touch{{settings_.body.ahead_m, 0.0}, {1.0, 0.0}, 0.5 * settings_.body.width_m};
  const Point ahead = direction(seen.yaw_WB_rad);
  const Point at = seen.p_WB + settings_.body.ahead_m * ahead;
  if (is_explained(touch, surfaces, seen) || !places_.add(at, ahead)) return std::nullopt;
  return at;
}

}  // namespace caravan::agent
