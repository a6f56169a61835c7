// SPDX-License-Identifier: Apache-2.0
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "robot_agent/shell/agent_shell.hpp"
#include "runtime/config/number_list.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/controller/crash_line.hpp"
#include "runtime/process/run_process.hpp"

namespace {

using namespace caravan;

constexpr std::uint32_t kHighestRobot = 65535;  // 16 bits in radio frames
constexpr std::uint32_t kNotGiven = std::numeric_limits<std::uint32_t>::max();

struct Chosen {
  std::string text;  // argument as given
  std::vector<std::uint32_t> robots;
};

Chosen choose(std::uint32_t one, const std::vector<std::string>& several) {
  if ((one != kNotGiven) == !several.empty() || several.size() > 1) {
    throw runtime::StartError{"give one of --robot I and --robots LIST (such as 1-15 or 1,3,5-8)"};
  }
  if (several.empty()) return {std::to_string(one), {one}};
  const auto robots = runtime::read_number_list(
      several.front(), {.option = "--robots", .lowest = 1, .highest = kHighestRobot, .most = kHighestRobot});
  return {several.front(), {robots.begin(), robots.end()}};
}

agent::Controllers::TraceFolder existing_folder(const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  if (!std::filesystem::is_directory(names.back()))
    throw runtime::StartError{"--trace: " + names.back() + " is not a folder: make it first"};
  return names.back();
}

/// A controller that cannot be made is found before the robot has one.
void make_once(const agent::Controllers& controllers, const std::vector<agent::Config>& configs) {
  runtime::Calls calls;
  const runtime::CallWatch watch{calls, [&](std::uint64_t call, runtime::CallWatch::Reason reason) {
                                   const bool is_stop = reason == runtime::CallWatch::Reason::kStop;
                                   spdlog::critical("controller {}, robot {}: its constructor {}",
                                                    controllers.name(), configs[call / 2].id.value,
                                                    to_text(reason));
                                   spdlog::shutdown();
                                   std::_Exit(is_stop ? runtime::kDone : runtime::kCouldNotStart);
                                 }};
  for (const agent::Config& config : configs) {
    const runtime::Calls::Call call{calls};
    (void)controllers.make(config);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::uint32_t one = kNotGiven;
  std::vector<std::string> several;
  std::vector<std::string> controller;
  std::vector<std::string> trace;
  const runtime::Program program{
      .name = "robot_agent",
      .purpose = "The controllers of robots; each has only the sensors, wheels and radio of its robot",
      .numbers = {{"--robot", "Number of the robot, from 1", false, &one}},
      .texts = {
          {"--robots", "Several robots in this process: 1-15, or 1,3,5-8", &several},
          {"--controller",
           "Their controller: paper, a shared library or a Python file (default: the scenario's)",
           &controller},
          {"--trace", "Existing folder for a record of their steps, for `caravan step-agent`", &trace}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        runtime::name_crashing_controllers(runtime::kFailed);
        const Chosen chosen = choose(one, several);
        const auto scenario = runtime::TomlDocument::load(start.scenario);
        std::vector<agent::Config> configs;
        for (const std::uint32_t robot : chosen.robots) {
          configs.push_back(agent::load_config(scenario, robot));
        }
        const agent::Controllers controllers{
            scenario, controller.empty() ? agent::controller_in(scenario) : controller.back(),
            existing_folder(trace)};
        make_once(controllers, configs);
        if (start.check_only) return runtime::kDone;
        const runtime::BusConfig bus{.role = "robot_agent " + chosen.text,
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        return agent::AgentShell{controllers, configs, bus, loop}.run();
      });
}
