// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiment/metrics/observation.hpp"
#include "experiment/metrics/run_facts.hpp"
#include "radio_emulator/medium/medium.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/pure/canonical_bytes.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "world_server/world.hpp"

namespace caravan::experiment {

/// World, radio medium and agents of one scenario in one process, stepped together exactly as the processes
/// are in lockstep: all robots sense, every agent answers, the frames are delivered with the poses of the
/// same stamp, the world advances.
class Engine {
 public:
  /// @param trace  existing folder for what each robot's controller is given and answers; none: no trace
  /// @throws runtime::StartError
  explicit Engine(const runtime::TomlDocument& scenario,
                  const std::optional<std::filesystem::path>& trace = std::nullopt)
      : Engine{scenario, agent::Controllers{scenario, agent::controller_in(scenario), trace}} {}
  /// With controllers that the scenario need not name.
  Engine(const runtime::TomlDocument& scenario, agent::Controllers controllers);

  /// One step of world, agents and radio. @pre !finished()
  /// @return the observation of the step, valid until the next call
  /// @throws runtime::ControllerFault, runtime::WriteError, world::PhysicsError: no step can follow
  const Observation& step();
  /// The state after the last step, without reports: the observation that ends a run.
  const Observation& last();

  /// Whether the run is decided: all items delivered, or time over.
  [[nodiscard]] bool finished() const { return world_.finished(); }
  [[nodiscard]] Time now() const { return world_.now(); }
  /// Warning of the physics in the last step; empty: none.
  [[nodiscard]] const std::string& complaint() const { return world_.complaint(); }
  /// Lines about what the radio drops of the last step's frames; each kind once.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] std::string digest() const;
  /// Bytes that the last step added to the world's and to the radio's hash chain; valid until the next step.
  [[nodiscard]] std::span<const std::uint8_t> world_link() const { return world_.chain_link(); }
  [[nodiscard]] std::span<const std::uint8_t> radio_link() const { return radio_link_.view(); }
  /// Of controllers, for a CallWatch.
  [[nodiscard]] runtime::Calls& calls() { return calls_; }
  /// What call number `calls` was, of the step at present.
  [[nodiscard]] std::string call_in_words(std::uint64_t calls) const;
  [[nodiscard]] const TimeSplit& time_split() const { return time_split_; }
  [[nodiscard]] Refusals refusals() const;

 private:
  void sense();
  void answer();
  void deliver();
  void look();

  world::World world_;
  radio::MediumConfig medium_;
  double wheel_limit_mps_ = 0.0;
  agent::Controllers controllers_;
  std::vector<agent::Config> configs_;  // [0] is robot 1, as in all that follow
  std::vector<runtime::GuardedController> agents_;
  std::vector<std::string> warnings_;
  runtime::Calls calls_;
  std::vector<caravan::Inputs> inputs_;
  std::vector<std::optional<world::Command>> commands_;
  std::vector<radio::Station> stations_;
  std::vector<radio::Transmission> transmissions_;
  pure::CanonicalBytes radio_link_;  // of the last step
  pure::HashChain radio_chain_;
  radio::Drops drops_;
  Refusals refusals_;  // of commands
  TimeSplit time_split_;
  Observation observation_;
};

}  // namespace caravan::experiment
