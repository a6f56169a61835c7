// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/config/toml_table.hpp"

namespace caravan::experiment {

struct StepAgentRequest {
  std::filesystem::path run;  ///< folder of a run with a trace
  std::uint32_t robot = 1;
  runtime::TomlDocument scenario;     ///< what the controller is told
  std::string controller;             ///< "paper" or the path of a controller's file
  std::optional<std::uint64_t> step;  ///< from 1: only this one is compared, and shown whole
  bool has_deadline = true;           ///< false: a debugger may keep the controller in a call
};

/// Gives a new controller what the robot's was given in the run, step by step, and names the first step that
/// it answers otherwise, with all values that differ. Of a killed run it uses the whole steps. With
/// StepAgentRequest::step it prints what the robot was given in that step, before the controller is called,
/// and both answers.
///
/// The trace begins where the robot's last controller of that run did, in its initial state.
///
/// @return 0: it answers the same in all steps, or in the one wanted; 1: it does not
/// @throws runtime::StartError when the trace cannot be read, the controller cannot be made, or it fails in a
/// step. One that does not return from a step within the deadline, or calls exit() in it, ends the process
/// with exit code 2.
[[nodiscard]] int step_agent(const StepAgentRequest& request, std::FILE* out);

}  // namespace caravan::experiment
