// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/shell/agent_shell.hpp"
#include "runtime/process/run_process.hpp"

int main(int argc, char** argv) {
  using namespace caravan;
  std::uint32_t robot = 0;
  const runtime::Program program{
      .name = "robot_agent",
      .purpose = "One robot's behaviour: knows its own sensors, wheels and radio, nothing else",
      .numbers = {{"--robot", "Number of the robot, from 1", true, &robot}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        const agent::Config config = agent::load_config(runtime::TomlDocument::load(start.scenario), robot);
        if (start.check_only) return runtime::kDone;
        const runtime::BusConfig bus{
            .role = "robot_agent " + std::to_string(robot), .domain = start.domain, .lease_s = start.lease_s};
        return agent::AgentShell{config, bus, loop}.run();
      });
}
