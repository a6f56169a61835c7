// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <caravan/condition.hpp>
#include "deploy/control/words.hpp"
#include "idl/control_types.hpp"

namespace caravan::deploy {

/// An action on processes.
struct ProcessAction {
  enum class Kind : std::uint8_t { kStart, kKill, kStop, kSuspend, kContinue, kRestart };
  Kind kind = Kind::kStart;
  std::vector<std::string> names;  ///< world, radio, robot 3
};
/// Starts a world that waits for this observer.
struct Go {};
/// Pauses the world before a step.
struct HoldAt {
  std::uint64_t step = 0;
};
/// Single-steps a paused world until a condition holds.
struct StepUntil {
  Condition condition;
  std::uint64_t most = 0;  ///< greatest number of steps
};
using DeployAction =
    std::variant<ProcessAction, Go, HoldAt, StepUntil, caravan_interfaces::msg::ControlRequest>;

struct ActionForm {
  std::string_view form;
  std::string_view meaning;
};
/// The table of actions; the forms of control_forms() belong to it too.
[[nodiscard]] std::span<const ActionForm> action_forms();

/// @param robots  number of robots
/// @throws WordsError
[[nodiscard]] DeployAction read_action(const std::string& line, std::uint32_t robots);

}  // namespace caravan::deploy
