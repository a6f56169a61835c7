// SPDX-License-Identifier: Apache-2.0
#include "world_server/config/world_config.hpp"

#include <cmath>
#include <numbers>

#include "runtime/scenario/bodies.hpp"
#include "world_server/config/checks.hpp"

namespace caravan::world {
namespace {

using runtime::kPlace_m;
using runtime::TomlTable;

// Sizes of solids: outside this range ODE computes with zeros or infinities.
constexpr runtime::Range kSize_m{0.001, 100000.0};
constexpr runtime::Range kHeight_m{0.001, 1000.0};

void require(TomlTable& table, std::string_view key) {
  if (!table.has(key)) table.fail(key, "is missing: add it to this table");
}

Box read_box(TomlTable& table, const WorldConfig& config) {
  Box box;
  require(table, "centre_m");
  require(table, "size_m");
  table.read("centre_m", box.centre_m, kPlace_m);
  table.read("size_m", box.size_m, kSize_m);
  table.read("yaw_rad", box.yaw_rad, {-2.0 * std::numbers::pi, 2.0 * std::numbers::pi});
  table.read("height_m", box.height_m, kHeight_m);
  table.refuse_unknown();
  check_solid(table, "centre_m", to_solid(box), config);
  return box;
}

Cylinder read_cylinder(TomlTable& table, const WorldConfig& config) {
  Cylinder cylinder;
  require(table, "centre_m");
  require(table, "radius_m");
  table.read("centre_m", cylinder.centre_m, kPlace_m);
  table.read("radius_m", cylinder.radius_m, kSize_m);
  table.read("height_m", cylinder.height_m, kHeight_m);
  table.refuse_unknown();
  check_solid(table, "centre_m", to_solid(cylinder), config);
  return cylinder;
}

Outline read_outline(TomlTable& table, const WorldConfig& config) {
  Outline outline;
  require(table, "points_m");
  table.read("points_m", outline.points_m, kPlace_m);
  table.read("height_m", outline.height_m, kHeight_m);
  table.refuse_unknown();
  check_outline(table, outline);
  check_solid(table, "points_m", to_solid(outline), config);
  return outline;
}

/// Scales the arena so that each robot has as much room as `arena_for_robots` robots have in the scenario.
void make_room(TomlTable& table, WorldConfig& config) {
  if (config.arena_for_robots == 0) return;
  for (const std::string_view solid : {"box", "cylinder", "outline"}) {
    if (table.has(solid))
      table.fail("arena_for_robots", "cannot be combined with obstacles, which would not move with it");
  }
  const double factor = std::sqrt(static_cast<double>(config.robots.count) / config.arena_for_robots);
  for (auto* lengths : {&config.arena_m, &config.start_low_m, &config.start_high_m}) {
    for (double& one : *lengths) one *= factor;
  }
}

void read_world(TomlTable& table, WorldConfig& config) {
  for (const std::string_view key : {"start_low_m", "start_high_m"}) require(table, key);
  table.read("step_s", config.step_s, {0.001, 1.0});
  table.read("substeps", config.substeps, {1, 1000});
  table.read("arena_m", config.arena_m, {1.0, 100000.0});
  table.read("wall_height_m", config.wall_height_m, kHeight_m);
  table.read("start_low_m", config.start_low_m, kPlace_m);
  table.read("start_high_m", config.start_high_m, kPlace_m);
  table.read("start_spacing_m", config.start_spacing_m, {0.01, 100.0});
  table.read("arena_for_robots", config.arena_for_robots);
  make_room(table, config);
  for (TomlTable& box : table.tables("box")) config.boxes.push_back(read_box(box, config));
  for (TomlTable& one : table.tables("cylinder")) config.cylinders.push_back(read_cylinder(one, config));
  for (TomlTable& one : table.tables("outline")) config.outlines.push_back(read_outline(one, config));
  table.refuse_unknown();
}

}  // namespace

double body_radius_m(const runtime::RobotsTable& robots) {
  const double behind = robots.body_length_m - robots.body_ahead_m;
  return std::hypot(std::max(behind, robots.body_ahead_m), 0.5 * robots.body_width_m);
}

WorldConfig load_world_config(const runtime::TomlDocument& scenario) {
  WorldConfig config;
  config.robots = runtime::read_robots(scenario);
  config.experiment = runtime::read_experiment(scenario);
  config.seed = runtime::read_seed(scenario);
  TomlTable world = scenario.table("world");
  read_world(world, config);
  check_world(world, config);
  check_robots(scenario.table("robots"), config);
  return config;
}

std::vector<std::uint32_t> read_bodies(const std::vector<std::string>& lists, const WorldConfig& config) {
  std::vector<std::uint32_t> bodies = runtime::read_bodies(lists, config.robots.count);
  if (!bodies.empty() && config.experiment.pacing != runtime::Pacing::kFree) {
    throw runtime::StartError{
        "--bodies: experiment.pacing must be \"free\", robots behind a bridge do not wait"};
  }
  return bodies;
}

}  // namespace caravan::world
