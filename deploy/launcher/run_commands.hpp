// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// The settings that all processes of a run share.
struct RunSetup {
  std::filesystem::path binaries;    ///< folder of world_server and the others
  std::filesystem::path agent = {};  ///< program in the place of robot_agent, given its options; empty: none
  std::filesystem::path scenario;    ///< the scenario file that they read
  std::uint32_t domain = 0;
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  double lease_s = 5.0;  ///< a process that is silent for this long counts as gone
};

/// Robots that share a process: first .. last.
struct RobotGroup {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
};
/// The groups of robots 1 .. robots, `size` in each; the last may be smaller. @pre size > 0
[[nodiscard]] std::vector<RobotGroup> groups_of(std::uint32_t robots, std::uint32_t size);
/// "3", or "1-4"
[[nodiscard]] std::string to_text(const RobotGroup& group);

/// Command lines; the first word is the program's path. More options may follow.
/// @param awaited  observer without which the world does not begin
[[nodiscard]] std::vector<std::string> world_command(const RunSetup& run, const std::string& awaited);
[[nodiscard]] std::vector<std::string> radio_command(const RunSetup& run);
/// @param robots  in the form of to_text()
[[nodiscard]] std::vector<std::string> agent_command(const RunSetup& run, const std::string& robots);

}  // namespace caravan::deploy
