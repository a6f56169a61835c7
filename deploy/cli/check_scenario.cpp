// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/check_scenario.hpp"

#include "deploy/cli/try_controllers.hpp"
#include "experiment/check/check_tables.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "world_server/config/world_config.hpp"
#include "world_server/world.hpp"

namespace caravan::deploy {

experiment::RunFacts check_tables(const runtime::TomlDocument& scenario, const std::string& controller) {
  experiment::RunFacts facts = experiment::check_tables(scenario);
  facts.controller = try_controllers(scenario, controller);
  return facts;
}

experiment::RunFacts check_scenario(const runtime::TomlDocument& scenario) {
  experiment::RunFacts facts = check_tables(scenario, agent::controller_in(scenario));
  const world::World trial{world::load_world_config(scenario)};
  return facts;
}

}  // namespace caravan::deploy
