// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "runtime/pure/hash_chain.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The samples that have arrived for the step. By robot: [0] is robot 1.
struct StepInputs {
  explicit StepInputs(std::uint32_t robots)
      : commands(robots), commanded_at(robots), radio_due(robots, false) {}

  std::vector<std::optional<Command>> commands;
  std::vector<Time> commanded_at;        ///< stamp of the step in which each arrived
  std::vector<std::uint32_t> reporting;  ///< robots that have reported in the open step
  std::vector<std::uint32_t> reported;   ///< robots that had reported when the bodies moved last
  std::vector<bool> radio_due;           ///< the radio has frames for the robot in the next step
  std::uint64_t radio_chain = pure::HashChain{}.value();  ///< the radio's hash chain
  bool radio_controlled = false;                          ///< the radio's links were overridden on request

  void command(std::uint32_t robot, const Command& command, Time stamp) {
    commands[robot - 1] = command;
    commanded_at[robot - 1] = stamp;
  }
  /// A robot has left: discards its command.
  void drop(std::uint32_t robot) { commands[robot - 1].reset(); }
  /// The bodies have moved. In pacing `free` commands hold until they are too old.
  void moved(bool commands_hold) {
    reported = std::exchange(reporting, {});
    if (!commands_hold) commands.assign(commands.size(), std::nullopt);
  }
  /// Drops the commands that arrived more than `longest` before `now`.
  void drop_older(Time now, Time longest) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (commands[i] && now - commanded_at[i] > longest) commands[i].reset();
    }
  }
  void forget_radio() { radio_due.assign(radio_due.size(), false); }
};

}  // namespace caravan::world
