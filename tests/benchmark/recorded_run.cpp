// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/recorded_run.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "build_paths.hpp"
#include "experiment/embedded/convert.hpp"
#include "radio_emulator/config/radio_config.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/paper_controller.hpp"
#include "world_server/world.hpp"

namespace caravan::benchmarks {

runtime::TomlDocument scaling_scenario(std::size_t robots) {
  toml::table tree = toml::parse_file(CARAVAN_SOURCE_DIR "/deploy/scenarios/scaling.toml");
  tree["robots"].as_table()->insert_or_assign("count", static_cast<std::int64_t>(robots));
  std::ostringstream text;
  text << tree;
  return runtime::TomlDocument::parse(text.str(), "scaling.toml");
}

RecordedRun record_run(std::size_t robots, std::size_t steps) {
  const runtime::TomlDocument scenario = scaling_scenario(robots);
  RecordedRun run{.world = world::load_world_config(scenario),
                  .radio = radio::load_radio_config(scenario),
                  .agents = {},
                  .starts = {},
                  .steps = {}};
  world::World world{run.world};
  run.starts.assign(world.poses().begin(), world.poses().end());
  std::vector<std::unique_ptr<agent::PaperController>> agents;
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    run.agents.push_back(agent::load_config(scenario, robot));
    agents.push_back(std::make_unique<agent::PaperController>(run.agents.back()));
  }
  radio::Drops drops;
  std::vector<std::vector<caravan::ReceivedFrame>> heard(robots);
  for (std::size_t i = 0; i < steps; ++i) {
    RecordedStep step;
    step.poses.assign(world.poses().begin(), world.poses().end());
    for (std::uint32_t robot = 1; robot <= robots; ++robot) {
      const world::Pose& pose = step.poses[robot - 1];
      step.stations.push_back({robot, pose.x_m, pose.y_m});
      step.inputs.push_back({.now = world.now(),
                             .sensors = world.sense(robot),
                             .heard = std::move(heard[robot - 1]),
                             .destination = {}});
      heard[robot - 1].clear();
      caravan::Outputs outputs = agents[robot - 1]->step(step.inputs.back());
      step.commands.emplace_back(world::Command{outputs.left_mps, outputs.right_mps, false});
      step.transmissions.push_back(experiment::to_transmission(robot, outputs));
    }
    for (radio::Reception& one :
         radio::deliver(run.radio, world.step(), step.stations, step.transmissions, drops)) {
      heard[one.robot - 1] = experiment::to_heard(one);
    }
    world.advance(step.commands);
    run.steps.push_back(std::move(step));
  }
  return run;
}

}  // namespace caravan::benchmarks
