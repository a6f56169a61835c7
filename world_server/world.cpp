// SPDX-License-Identifier: Apache-2.0
#include "world_server/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/config/start_error.hpp"
#include "runtime/pure/assert.hpp"
#include "runtime/pure/canonical_bytes.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "world_server/physics/dynamics.hpp"
#include "world_server/physics/physics_error.hpp"
#include "world_server/referee/contact_episodes.hpp"
#include "world_server/referee/items.hpp"
#include "world_server/sensors/devices.hpp"
#include "world_server/sensors/sonar.hpp"
#include "world_server/starts/room.hpp"
#include "world_server/starts/starts.hpp"

namespace caravan::world {
namespace {

Time seconds(double value) { return Time{std::llround(value * 1e9)}; }

ItemRules item_rules(const WorldConfig& config) {
  return {.source = to_point(config.robots.source_m),
          .destination = to_point(config.robots.destination_m),
          .service_radius_m = config.robots.service_radius_m,
          .items = config.experiment.items};
}

Sensors nothing_sensed() {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  Sensors sensors;
  sensors.sonar_range_m.fill(kUnknown);
  sensors.sonar_age_s.fill(kUnknown);
  sensors.position = {kUnknown, kUnknown};
  sensors.yaw_rad = kUnknown;
  sensors.left_wheel_rad = sensors.right_wheel_rad = kUnknown;
  return sensors;
}

}  // namespace

struct World::Impl {
  explicit Impl(const WorldConfig& given)
      : config{given},
        count{config.robots.count},
        period{seconds(config.step_s)},
        max_time{seconds(config.experiment.max_time_s)},
        dynamics{config, choose_starts(config)},
        sonars{config},
        items{item_rules(config), count} {
    for (std::uint32_t robot = 1; robot <= count; ++robot)
      devices.emplace_back(config.robots, config.seed, robot);
    sonars.place(dynamics.poses());
  }

  [[nodiscard]] bool is_present(std::uint32_t robot) const {
    return !std::isnan(dynamics.poses()[robot - 1].x_m);
  }

  void obey(std::uint32_t robot, const std::optional<Command>& command) {
    const Command done = command.value_or(
        Command{.left_mps = 0.0, .right_mps = 0.0, .gripper_closed = items.is_closed(robot)});
    if (is_present(robot)) {
      const auto event = items.grip(robot, dynamics.poses()[robot - 1], done.gripper_closed);
      if (event) item_events.push_back(*event);
    }
    dynamics.drive(robot - 1, done.left_mps, done.right_mps);
    link.word(command.has_value() ? 1 : 0);
    link.real(done.left_mps);
    link.real(done.right_mps);
    link.word(done.gripper_closed ? 1 : 0);
  }

  void referee() {
    touching.clear();
    for (const Touch& touch : dynamics.touches()) touching.push_back({touch.robot, touch.other});
    begun = contacts.begun(now(), touching);
  }

  /// Start of the bytes to be added to the link: its front, or after the robots that were placed since the
  /// last step.
  std::size_t begin_link() {
    if (link_whole) link.clear();
    link_whole = false;
    return link.view().size();
  }

  /// Records that a robot was placed or removed.
  void moved(std::uint32_t robot) {
    sonars.place(dynamics.poses());
    const std::size_t before = begin_link();
    link.word(robot);
    write_poses();
    chain.link(link.view().subspan(before));
  }

  void write_poses() {
    for (const Pose& pose : dynamics.poses()) {
      link.real(pose.x_m);
      link.real(pose.y_m);
      link.real(pose.yaw_rad);
    }
  }

  [[nodiscard]] Time now() const { return static_cast<Time::rep>(step) * period; }

  WorldConfig config;
  std::uint32_t count;
  Time period;
  Time max_time;
  std::uint64_t step = 0;
  Dynamics dynamics;
  Sonars sonars;
  std::vector<Devices> devices;  // by robot
  Items items;
  ContactEpisodes contacts;
  pure::CanonicalBytes link;  // of the last step, or of the next one so far
  bool link_whole = false;    // its step has been taken
  pure::HashChain chain;
  std::vector<ItemEvent> item_events;
  std::vector<ContactEpisode> touching;
  std::vector<ContactEpisode> begun;
};

World::World(const WorldConfig& config) try : impl_{std::make_unique<Impl>(config)} {
} catch (const PhysicsError& error) {
  throw runtime::StartError{std::string{"robots: the physics refuses this body: "} + error.what()};
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Sensors World::sense(std::uint32_t robot) {
  CARAVAN_ASSERT(robot >= 1 && robot <= impl_->count);
  const std::size_t index = robot - 1;
  if (!impl_->is_present(robot)) return nothing_sensed();
  Devices& devices = impl_->devices[index];
  const Pose seen = devices.locate(impl_->dynamics.poses()[index]);
  Sensors sensors;
  sensors.sonar_range_m = devices.sonar(impl_->sonars.ranges(index));
  sensors.position = {seen.x_m, seen.y_m};
  sensors.yaw_rad = seen.yaw_rad;
  sensors.left_wheel_rad = impl_->dynamics.left_wheel_rad(index);
  sensors.right_wheel_rad = impl_->dynamics.right_wheel_rad(index);
  sensors.holding = impl_->items.holds(robot);
  return sensors;
}

std::span<const Pose> World::poses() const { return impl_->dynamics.poses(); }

void World::advance(std::span<const std::optional<Command>> commands) {
  CARAVAN_ASSERT(commands.size() == impl_->count);
  impl_->item_events.clear();
  const std::size_t before = impl_->begin_link();
  impl_->link.word(++impl_->step);
  for (std::uint32_t robot = 1; robot <= impl_->count; ++robot) impl_->obey(robot, commands[robot - 1]);
  impl_->dynamics.advance();
  impl_->write_poses();
  impl_->chain.link(impl_->link.view().subspan(before));
  impl_->link_whole = true;
  impl_->sonars.place(impl_->dynamics.poses());
  impl_->referee();
}

const std::string& World::complaint() const { return impl_->dynamics.complaint(); }

std::string World::place(std::uint32_t robot, const Pose& pose) {
  CARAVAN_ASSERT(robot >= 1 && robot <= impl_->count);
  if (!impl_->is_present(robot)) return "robot " + std::to_string(robot) + " is not in the world";
  std::string obstacle = obstacle_at(impl_->config, impl_->dynamics.poses(), robot, pose);
  if (!obstacle.empty()) return obstacle;
  impl_->dynamics.place(robot - 1, pose);
  impl_->moved(robot);
  return "";
}

std::string World::remove(std::uint32_t robot) {
  CARAVAN_ASSERT(robot >= 1 && robot <= impl_->count);
  if (!impl_->is_present(robot)) return "robot " + std::to_string(robot) + " is not in the world";
  const auto poses = impl_->dynamics.poses();
  const auto present = std::ranges::count_if(poses, [](const Pose& pose) { return !std::isnan(pose.x_m); });
  if (present == 1) return "it is the last one: a world without robots takes no step";
  impl_->dynamics.remove(robot - 1);
  impl_->items.withdraw(robot);
  impl_->moved(robot);
  return "";
}

std::string World::spawn(std::uint32_t robot, const Pose& pose) {
  CARAVAN_ASSERT(robot >= 1 && robot <= impl_->count);
  if (impl_->is_present(robot)) return "robot " + std::to_string(robot) + " is in the world already";
  std::string obstacle = obstacle_at(impl_->config, impl_->dynamics.poses(), robot, pose);
  if (!obstacle.empty()) return obstacle;
  impl_->dynamics.place(robot - 1, pose);
  impl_->moved(robot);
  return "";
}

bool World::is_present(std::uint32_t robot) const { return impl_->is_present(robot); }

std::uint64_t World::step() const { return impl_->step; }
Time World::now() const { return impl_->now(); }
std::span<const ContactEpisode> World::contacts() const { return impl_->begun; }
std::span<const ItemEvent> World::item_events() const { return impl_->item_events; }
std::uint32_t World::items_delivered() const { return impl_->items.delivered(); }
std::uint64_t World::empty_closings() const { return impl_->items.empty_closings(); }
bool World::finished() const { return impl_->items.all_delivered() || impl_->now() >= impl_->max_time; }
std::uint64_t World::chain() const { return impl_->chain.value(); }
std::span<const std::uint8_t> World::chain_link() const { return impl_->link.view(); }

}  // namespace caravan::world
