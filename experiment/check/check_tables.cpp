// SPDX-License-Identifier: Apache-2.0
#include "experiment/check/check_tables.hpp"

#include "hardware_bridge/config/bridge_table.hpp"
#include "radio_emulator/config/radio_config.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "runtime/scenario/name.hpp"
#include "world_server/config/world_config.hpp"

namespace caravan::experiment {
namespace {

std::string to_text(agent::Sharing sharing) {
  switch (sharing) {
    case agent::Sharing::kNone:
      return "none";
    case agent::Sharing::kPartial:
      return "partial";
    case agent::Sharing::kFull:
      return "full";
  }
  return "";
}

}  // namespace

RunFacts check_tables(const runtime::TomlDocument& scenario) {
  const world::WorldConfig world_config = world::load_world_config(scenario);
  (void)radio::load_radio_config(scenario);
  (void)bridge::read_bridge(scenario);
  const agent::Config agent_config = agent::load_config(scenario, 1);
  const std::chrono::duration<double> max_time{world_config.experiment.max_time_s};
  return {.scenario = name_of(scenario),
          .engine = {},
          .controller = {},
          .mode = to_text(agent_config.sharing.mode),
          .seed = world_config.seed,
          .robots = world_config.robots.count,
          .items = world_config.experiment.items,
          .max_time = std::chrono::duration_cast<Time>(max_time)};
}

}  // namespace caravan::experiment
