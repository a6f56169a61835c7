// SPDX-License-Identifier: Apache-2.0
#include "world_server/config/checks.hpp"

#include <algorithm>
#include <sstream>

namespace caravan::world {
namespace {

constexpr double kRounding = 1e-6;
// A world beyond these limits is a mistake, and would take minutes to check or more memory than available.
constexpr std::size_t kMostPoints = 1000;  // of an outline
constexpr std::size_t kMostSolids = 10'000;
constexpr double kMostCover = 20.0;  // arenas

template <typename... Parts>
std::string words(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

bool is_in_arena(Point point, const WorldConfig& config) {
  return std::abs(point.x) <= 0.5 * config.arena_m[0] + kRounding &&
         std::abs(point.y) <= 0.5 * config.arena_m[1] + kRounding;
}

std::string arena_text(const WorldConfig& config) {
  return words("the arena, which is x ", -0.5 * config.arena_m[0], " to ", 0.5 * config.arena_m[0], ", y ",
               -0.5 * config.arena_m[1], " to ", 0.5 * config.arena_m[1]);
}

std::vector<Solid> solids_of(const WorldConfig& config) {
  std::vector<Solid> solids;
  for (const Box& box : config.boxes) solids.push_back(to_solid(box));
  for (const Cylinder& cylinder : config.cylinders) solids.push_back(to_solid(cylinder));
  for (const Outline& outline : config.outlines) solids.push_back(to_solid(outline));
  return solids;
}

void check_site(const runtime::TomlTable& robots, std::string_view key, Point site,
                const WorldConfig& config) {
  if (!is_in_arena(site, config)) {
    robots.fail(key, words("(", site.x, ", ", site.y, ") lies outside ", arena_text(config)));
  }
  for (const Solid& solid : solids_of(config)) {
    if (contains(solid, site)) {
      robots.fail(key, words("(", site.x, ", ", site.y, ") lies inside an obstacle: move one of them"));
    }
  }
}

void check_amount(const runtime::TomlTable& world, const WorldConfig& config) {
  const std::vector<Solid> solids = solids_of(config);
  if (solids.size() > kMostSolids) {
    world.fail("arena_m", words("holds ", solids.size(), " obstacles; at most ", kMostSolids));
  }
  double area = 0.0;
  for (const Solid& solid : solids) {
    const Point size = extent_of(solid).high - extent_of(solid).low;
    area += size.x * size.y;
  }
  if (area > kMostCover * config.arena_m[0] * config.arena_m[1]) {
    world.fail("arena_m", words("is covered more than ", kMostCover, " times over by its obstacles"));
  }
}

}  // namespace

void check_solid(const runtime::TomlTable& table, std::string_view key, const Solid& solid,
                 const WorldConfig& config) {
  const Extent extent = extent_of(solid);
  if (is_in_arena(extent.low, config) && is_in_arena(extent.high, config)) return;
  table.fail(key, "reaches outside " + arena_text(config) + ": move it or make it smaller");
}

void check_outline(const runtime::TomlTable& table, const Outline& outline) {
  if (outline.points_m.size() < 3) {
    table.fail("points_m", words("needs at least 3 points, has ", outline.points_m.size()));
  }
  if (outline.points_m.size() > kMostPoints) {
    table.fail("points_m", words("has ", outline.points_m.size(), " points; at most ", kMostPoints));
  }
  const Polygon polygon = counter_clockwise(outline);
  if (!is_simple(polygon)) {
    table.fail("points_m", "crosses or touches itself: give the corners in order, each once");
  }
  const Solid solid = to_solid(outline);
  for (const Box& box : ring_of_boxes(outline)) {
    for (const Point corner : corners(box)) {
      if (distance_to(solid, corner) <= kRounding) continue;
      table.fail("points_m", words("is thinner than ", kRingThickness, " m near (", box.centre_m[0], ", ",
                                   box.centre_m[1], "): widen it or use [[world.box]]"));
    }
  }
}

void check_world(const runtime::TomlTable& world, const WorldConfig& config) {
  check_amount(world, config);
  if (config.start_low_m[0] > config.start_high_m[0] || config.start_low_m[1] > config.start_high_m[1]) {
    world.fail("start_high_m",
               "must not be below start_low_m: give the lower left and the upper right corner");
  }
  for (const std::string_view key : {"start_low_m", "start_high_m"}) {
    const Point corner = to_point(key == "start_low_m" ? config.start_low_m : config.start_high_m);
    if (!is_in_arena(corner, config)) world.fail(key, "lies outside " + arena_text(config));
  }
  // A body that moves more than half of the thinnest wall in one physics step could come out on its far side.
  const double stride = config.robots.wheel_limit_mps * config.step_s / config.substeps;
  if (stride > 0.5 * kRingThickness) {
    world.fail("substeps", words("a robot would move ", stride, " m in a physics step; at most ",
                                 0.5 * kRingThickness, " keeps it out of walls: use more substeps"));
  }
  const double apart = 2.0 * body_radius_m(config.robots);
  if (config.start_spacing_m < apart) {
    world.fail("start_spacing_m",
               words("must be at least ", apart, ", twice the body's radius, is ", config.start_spacing_m));
  }
}

void check_robots(const runtime::TomlTable& robots, const WorldConfig& config) {
  const runtime::RobotsTable& body = config.robots;
  if (body.body_ahead_m >= body.body_length_m) {
    robots.fail("body_ahead_m", "must be below body_length_m: the axle lies under the body");
  }
  if (body.track_m > body.body_width_m) {
    robots.fail("track_m", "must be at most body_width_m: the wheels lie within the body");
  }
  if (body.body_height_m <= body.wheel_radius_m) {
    robots.fail("body_height_m", "must be above wheel_radius_m: the axle lies inside the body");
  }
  check_site(robots, "source_m", to_point(body.source_m), config);
  if (config.experiment.items > 0) {
    check_site(robots, "destination_m", to_point(body.destination_m), config);
  }
}

}  // namespace caravan::world
