// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/run_commands.hpp"

#include <algorithm>

namespace caravan::deploy {
namespace {

std::vector<std::string> command(const RunSetup& run, const std::filesystem::path& program,
                                 const std::vector<std::string>& options) {
  std::vector<std::string> line{program,
                                "--scenario",
                                run.scenario,
                                "--domain",
                                std::to_string(run.domain),
                                "--lease",
                                std::to_string(run.lease_s),
                                "--transport",
                                to_text(run.transport)};
  line.insert(line.end(), options.begin(), options.end());
  return line;
}

}  // namespace

std::vector<RobotGroup> groups_of(std::uint32_t robots, std::uint32_t size) {
  std::vector<RobotGroup> groups;
  for (std::uint32_t first = 1; first <= robots; first += size)
    groups.push_back({first, std::min(robots, first + size - 1)});
  return groups;
}

std::string to_text(const RobotGroup& group) {
  const std::string first = std::to_string(group.first);
  return group.first == group.last ? first : first + "-" + std::to_string(group.last);
}

std::vector<std::string> world_command(const RunSetup& run, const std::string& awaited) {
  return command(run, run.binaries / "world_server", {"--await", awaited});
}

std::vector<std::string> radio_command(const RunSetup& run) {
  return command(run, run.binaries / "radio_emulator", {});
}

std::vector<std::string> agent_command(const RunSetup& run, const std::string& robots) {
  const bool are_several = robots.find('-') != std::string::npos;
  const std::filesystem::path agent = run.agent.empty() ? run.binaries / "robot_agent" : run.agent;
  return command(run, agent, {are_several ? "--robots" : "--robot", robots});
}

}  // namespace caravan::deploy
