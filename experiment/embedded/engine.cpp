// SPDX-License-Identifier: Apache-2.0
#include "experiment/embedded/engine.hpp"

#include <utility>

#include "experiment/embedded/convert.hpp"
#include "experiment/embedded/stopwatch.hpp"
#include "experiment/metrics/csv_file.hpp"
#include "radio_emulator/config/radio_config.hpp"
#include "radio_emulator/medium/chain.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "runtime/pure/assert.hpp"
#include "runtime/pure/digest.hpp"

namespace caravan::experiment {

Engine::Engine(const runtime::TomlDocument& scenario, agent::Controllers controllers)
    : world_{world::load_world_config(scenario)},
      medium_{radio::load_radio_config(scenario)},
      controllers_{std::move(controllers)} {
  const runtime::RobotsTable robots = runtime::read_robots(scenario);
  wheel_limit_mps_ = robots.wheel_limit_mps;
  for (std::uint32_t robot = 1; robot <= robots.count; ++robot) {
    configs_.push_back(agent::load_config(scenario, robot));
    agents_.push_back(controllers_.make_guarded(configs_.back()));
    observation_.members.push_back(robot);
    observation_.poses.push_back({.robot = robot});
    stations_.push_back({.robot = robot});
  }
  inputs_.resize(robots.count);
  commands_.resize(robots.count);
  transmissions_.resize(robots.count);
}

const Observation& Engine::step() {
  CARAVAN_ASSERT(!finished());
  Stopwatch watch;
  look();
  sense();
  time_split_.sensors_s += watch.lap_s();
  answer();
  time_split_.agents_s += watch.lap_s();
  deliver();
  time_split_.radio_s += watch.lap_s();
  world_.advance(commands_);
  time_split_.physics_s += watch.lap_s();
  return observation_;
}

const Observation& Engine::last() {
  look();
  observation_.last = finished();
  if (observation_.last) observation_.members.clear();
  return observation_;
}

void Engine::look() {
  observation_.stamp = world_.now();
  const auto poses = world_.poses();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    observation_.poses[i].place = {poses[i].x_m, poses[i].y_m};
    observation_.poses[i].yaw_rad = poses[i].yaw_rad;
    stations_[i].x_m = poses[i].x_m;
    stations_[i].y_m = poses[i].y_m;
  }
  observation_.contacts.clear();
  for (const world::ContactEpisode& contact : world_.contacts()) {
    observation_.contacts.push_back({.robot = contact.robot, .other = contact.other});
  }
  observation_.item_events.clear();
  for (const world::ItemEvent& event : world_.item_events()) {
    const bool pick_up = event.kind == world::ItemEvent::Kind::kPickUp;
    observation_.item_events.push_back(
        {.kind = pick_up ? ItemEvent::Kind::kPickUp : ItemEvent::Kind::kDelivery, .robot = event.robot});
  }
  observation_.items_delivered = world_.items_delivered();
  observation_.agent_reports.clear();
}

void Engine::sense() {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    inputs_[i].now = world_.now();
    inputs_[i].sensors = world_.sense(static_cast<std::uint32_t>(i + 1));
    inputs_[i].destination = controllers_.destination_in_sight(inputs_[i].sensors, configs_[i]);
  }
}

void Engine::answer() {
  warnings_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const auto robot = static_cast<std::uint32_t>(i + 1);
    caravan::Outputs outputs = [&] {
      const runtime::Calls::Call call{calls_};
      return agents_[i].step(inputs_[i]);
    }();
    for (const std::string& warning : agents_[i].warnings()) warnings_.push_back(warning);
    inputs_[i].heard.clear();
    commands_[i] = to_command(outputs, wheel_limit_mps_, refusals_);
    transmissions_[i] = to_transmission(robot, outputs);
    if (outputs.report) observation_.agent_reports.push_back(to_report(robot, *outputs.report));
  }
}

void Engine::deliver() {
  const std::int64_t stamp = world_.now().count();
  auto receptions =
      radio::deliver(medium_, static_cast<std::uint64_t>(stamp), stations_, transmissions_, drops_);
  radio_link_ = radio::chain_link(stamp, transmissions_, receptions);
  radio_chain_.link(radio_link_.view());
  for (radio::Reception& reception : receptions) inputs_[reception.robot - 1].heard = to_heard(reception);
}

Refusals Engine::refusals() const {
  Refusals all = refusals_;
  all.frames_over_mtu = drops_.over_mtu;
  all.frames_on_bad_channel = drops_.bad_channel;
  all.frames_lost = drops_.lost;
  all.frames_queue_full = drops_.queue_full;
  return all;
}

std::string Engine::call_in_words(std::uint64_t calls) const {
  const std::uint64_t call = calls / 2;
  return "controller " + controllers_.name() + ", robot " + std::to_string(call % agents_.size() + 1) +
         ", step " + std::to_string(call / agents_.size() + 1) + " (" + fixed(in_seconds(world_.now()), 3) +
         " s)";
}

std::string Engine::digest() const { return pure::digest(world_.chain(), radio_chain_.value()); }

}  // namespace caravan::experiment
