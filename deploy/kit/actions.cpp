// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/actions.hpp"

#include <array>
#include <optional>

namespace caravan::deploy {
namespace {

using Kind = ProcessAction::Kind;

struct ProcessVerb {
  std::string_view verb;
  Kind kind;
};
constexpr std::array kProcessVerbs{
    ProcessVerb{"start", Kind::kStart},       ProcessVerb{"kill", Kind::kKill},
    ProcessVerb{"stop", Kind::kStop},         ProcessVerb{"suspend", Kind::kSuspend},
    ProcessVerb{"continue", Kind::kContinue}, ProcessVerb{"restart", Kind::kRestart}};

constexpr std::array kForms{
    ActionForm{"start WHO",
               "starts processes; WHO: world, radio, robot 3, robot 1,2, robot 1-4, robots or all"},
    ActionForm{"kill WHO", "SIGKILL: ends at once, without an orderly shutdown"},
    ActionForm{"stop WHO", "SIGTERM, then waits for the end; fails if that takes longer than 2 s"},
    ActionForm{"suspend WHO", "SIGSTOP: alive, but does nothing"},
    ActionForm{"continue WHO", "SIGCONT"},
    ActionForm{"restart WHO", "kill, then start"},
    ActionForm{"go", "starts a world that waits because of hold_start"},
    ActionForm{"hold_at STEP", "pauses the world before this step, and waits until it is there"},
    ActionForm{"step_until MOST CONDITION",
               "single-steps a paused world until the condition holds, at most MOST steps"},
};

std::vector<std::string> read_names(Words& words, std::uint32_t robots) {
  std::vector<std::string> names;
  const auto add_robots = [&](const std::vector<std::uint32_t>& some) {
    for (const std::uint32_t robot : some) {
      if (robot > robots)
        throw WordsError{"there is no robot " + std::to_string(robot) + ", only 1 to " +
                         std::to_string(robots)};
      names.push_back("robot " + std::to_string(robot));
    }
    for (std::uint32_t robot = 1; some.empty() && robot <= robots; ++robot)
      names.push_back("robot " + std::to_string(robot));
  };
  const std::string who = words.word("who: world, radio, robot N, robots or all");
  if (who == "world" || who == "radio") {
    names.push_back(who);
  } else if (who == "robot") {
    add_robots(words.robots());
  } else if (who == "robots") {
    add_robots({});
  } else if (who == "all") {
    names = {"world", "radio"};
    add_robots({});
  } else {
    throw WordsError{"\"" + who + "\" is not a process: use world, radio, robot N, robots or all"};
  }
  return names;
}

StepUntil read_step_until(const std::string& line, Words& words) {
  const std::string most = words.peek();
  const std::uint64_t count = words.count("the most steps", 1);
  const std::size_t condition = line.find(most, line.find("step_until") + 10) + most.size();
  return {Condition{line.substr(condition)}, count};
}

}  // namespace

std::span<const ActionForm> action_forms() { return kForms; }

DeployAction read_action(const std::string& line, std::uint32_t robots) {
  Words words{split(line)};
  if (words.is_empty()) throw WordsError{"an action is empty"};
  for (const ProcessVerb& verb : kProcessVerbs) {
    if (!words.take_if(verb.verb)) continue;
    ProcessAction action{verb.kind, read_names(words, robots)};
    words.end();
    return action;
  }
  if (words.take_if("go")) {
    words.end();
    return Go{};
  }
  if (words.take_if("hold_at")) {
    const HoldAt action{words.count("the step", 0)};
    words.end();
    if (action.step == 0) throw WordsError{"step 0 cannot be held: it is under way from the start"};
    return action;
  }
  if (words.take_if("step_until")) return read_step_until(line, words);
  if (const auto request = read_control(words)) return *request;
  throw WordsError{"there is no action \"" + words.peek() + "\""};
}

}  // namespace caravan::deploy
