// SPDX-License-Identifier: Apache-2.0
// The world server without physics: its real shell with a World that costs nothing.
//
// Robots stand still for ever, 10 m apart, except for pairs that are 1 m apart, so that 30 % of the robots
// receive something in each step. This file defines the members of World; the linker then does not take the
// real ones.
#include <cmath>
#include <limits>
#include <string>

#include "world_server/world.hpp"

namespace caravan::world {
namespace {

constexpr double kShareInPairs = 0.3;
constexpr double kApart_m = 10.0;
constexpr double kInPair_m = 1.0;

std::vector<Pose> formation(std::uint32_t robots) {
  std::vector<Pose> poses;
  const auto in_pairs = 2 * static_cast<std::uint32_t>(std::lround(kShareInPairs * robots / 2.0));
  for (std::uint32_t i = 0; i < robots; ++i) {
    const bool is_second = i < in_pairs && i % 2 == 1;
    const double x_m = kApart_m * (is_second ? i - 1 : i);
    poses.push_back({.x_m = x_m, .y_m = is_second ? kInPair_m : 0.0, .yaw_rad = 0.0});
  }
  return poses;
}

}  // namespace

struct World::Impl {
  std::vector<Pose> poses;
  Time period;
  Time max_time;
  std::uint64_t step = 0;
};

World::World(const WorldConfig& config)
    : impl_{
          std::make_unique<Impl>(Impl{.poses = formation(config.robots.count),
                                      .period = Time{std::llround(config.step_s * 1e9)},
                                      .max_time = Time{std::llround(config.experiment.max_time_s * 1e9)}})} {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Sensors World::sense(std::uint32_t robot) {
  Sensors sensors;
  sensors.sonar_range_m.fill(std::numeric_limits<double>::infinity());
  sensors.position = {impl_->poses[robot - 1].x_m, impl_->poses[robot - 1].y_m};
  return sensors;
}
std::span<const Pose> World::poses() const { return impl_->poses; }
void World::advance(std::span<const std::optional<Command>> /*commands*/) { ++impl_->step; }
std::string World::place(std::uint32_t /*robot*/, const Pose& /*pose*/) { return "this world stands still"; }
std::string World::remove(std::uint32_t /*robot*/) { return "this world stands still"; }
std::string World::spawn(std::uint32_t /*robot*/, const Pose& /*pose*/) { return "this world stands still"; }
bool World::is_present(std::uint32_t /*robot*/) const { return true; }
std::uint64_t World::step() const { return impl_->step; }
Time World::now() const { return static_cast<Time::rep>(impl_->step) * impl_->period; }
std::span<const ContactEpisode> World::contacts() const { return {}; }
std::span<const ItemEvent> World::item_events() const { return {}; }
const std::string& World::complaint() const {
  static const std::string kNone;
  return kNone;
}
std::uint32_t World::items_delivered() const { return 0; }
std::uint64_t World::empty_closings() const { return 0; }
bool World::finished() const { return now() >= impl_->max_time; }
std::uint64_t World::chain() const { return 0; }
std::span<const std::uint8_t> World::chain_link() const { return {}; }

}  // namespace caravan::world
