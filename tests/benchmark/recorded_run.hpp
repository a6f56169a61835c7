// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <optional>
#include <vector>

#include "radio_emulator/medium/medium.hpp"
#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"
#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

/// The inputs and outputs of each part of a run, so that each part can be repeated alone.
namespace caravan::benchmarks {

struct RecordedStep {
  std::vector<world::Pose> poses;
  std::vector<radio::Station> stations;
  std::vector<caravan::Inputs> inputs;  // [0] is robot 1; likewise in the members below
  std::vector<radio::Transmission> transmissions;
  std::vector<std::optional<world::Command>> commands;
};

struct RecordedRun {
  world::WorldConfig world;
  radio::MediumConfig radio;
  std::vector<agent::Config> agents;
  std::vector<world::Pose> starts;
  std::vector<RecordedStep> steps;
};

/// deploy/scenarios/scaling.toml with this number of robots.
[[nodiscard]] runtime::TomlDocument scaling_scenario(std::size_t robots);

/// Records the first steps of this scenario in the embedded engine.
[[nodiscard]] RecordedRun record_run(std::size_t robots, std::size_t steps);

}  // namespace caravan::benchmarks
