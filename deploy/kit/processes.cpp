// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/processes.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace caravan::deploy {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kStopPatience = 2000ms;
constexpr auto kKillPatience = 5000ms;

constexpr std::string_view kRobot = "robot ";
constexpr std::string_view kRobots = "robots ";

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// The group of the robot; for an unknown robot: itself.
RobotGroup group_of(std::uint32_t robot, const ProcessSetup& setup) {
  for (const RobotGroup& group : groups_of(setup.robots, setup.agents_per_process)) {
    if (robot >= group.first && robot <= group.last) return group;
  }
  return {robot, robot};
}

}  // namespace

Processes::Processes(ProcessSetup setup, std::function<void(const std::string&)> on_end)
    : setup_{std::move(setup)}, on_end_{std::move(on_end)}, memory_{setup_.run.domain} {}

void Processes::stop_all() {
  note_shared_memory();
  for (auto& [name, life] : lives_) {
    life.process->signal(SIGTERM);
    life.process->signal(SIGCONT);
  }
  const auto deadline = Clock::now() + kStopPatience;
  for (auto& [name, life] : lives_) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    (void)life.process->wait(std::max(left, 0ms));
  }
}

std::string Processes::process_of(const std::string& name) const {
  if (!name.starts_with(kRobot)) return name;
  const auto robot = static_cast<std::uint32_t>(std::stoul(name.substr(kRobot.size())));
  const RobotGroup group = group_of(robot, setup_);
  return std::string{group.first == group.last ? kRobot : kRobots} + to_text(group);
}

std::vector<std::string> Processes::processes_of(const std::vector<std::string>& names) const {
  std::vector<std::string> processes;
  for (const std::string& name : names) {
    const std::string process = process_of(name);
    if (std::find(processes.begin(), processes.end(), process) == processes.end())
      processes.push_back(process);
  }
  return processes;
}

std::vector<std::string> Processes::command_line(const std::string& name) const {
  std::vector<std::string> line;
  if (name == "world") {
    line = world_command(setup_.run, setup_.awaited);
  } else if (name == "radio") {
    line = radio_command(setup_.run);
  } else {
    line = agent_command(setup_.run, name.substr(name.find(' ') + 1));
  }
  if (const auto more = setup_.arguments.find(name); more != setup_.arguments.end())
    line.insert(line.end(), more->second.begin(), more->second.end());
  return line;
}

void Processes::start(const std::string& name) {
  Life& life = lives_[name];
  const std::string number = ++life.lives == 1 ? "" : "." + std::to_string(life.lives);
  life.suspended = false;
  life.process =
      std::make_unique<Process>(command_line(name), setup_.folder / (file_name(name) + number + ".log"));
}

bool Processes::is_running(const std::string& name) const {
  const auto found = lives_.find(name);
  return found != lives_.end() && !found->second.process->wait(0ms);
}

std::string Processes::end(const std::string& name, int number, std::chrono::milliseconds patience) {
  Process& process = *lives_.at(name).process;
  memory_.note(process.pid());
  process.signal(number);
  process.signal(SIGCONT);
  if (!process.wait(patience))
    return name + " did not end within " + std::to_string(patience.count()) + " ms";
  on_end_(name);
  return "";
}

std::string Processes::do_to(const std::string& name, Kind kind) {
  if (kind != Kind::kStart && !lives_.contains(name)) return name + " was never started";
  const bool runs = is_running(name);
  switch (kind) {
    case Kind::kStart:
      if (runs) return name + " is already running";
      start(name);
      return "";
    case Kind::kKill:
      return end(name, SIGKILL, kKillPatience);
    case Kind::kRestart: {
      std::string wrong = end(name, SIGKILL, kKillPatience);
      start(name);
      return wrong;
    }
    case Kind::kStop:
      return runs ? end(name, SIGTERM, kStopPatience) : name + " is not running";
    case Kind::kSuspend:
    case Kind::kContinue:
      if (!runs) return name + " is not running";
      lives_.at(name).suspended = kind == Kind::kSuspend;
      lives_.at(name).process->signal(kind == Kind::kSuspend ? SIGSTOP : SIGCONT);
      return "";
  }
  return "";
}

std::string Processes::act(const ProcessAction& action) {
  const std::vector<std::string> names = processes_of(action.names);
  if (action.kind == Kind::kKill || action.kind == Kind::kRestart) {
    // Signals all at once, then waits for them one after the other.
    for (const std::string& name : names) {
      if (!is_running(name)) continue;
      memory_.note(lives_.at(name).process->pid());
      lives_.at(name).process->signal(SIGKILL);
    }
  }
  std::string wrong;
  for (const std::string& name : names) {
    const std::string text = do_to(name, action.kind);
    wrong += (wrong.empty() || text.empty() ? "" : "; ") + text;
  }
  return wrong;
}

void Processes::note_shared_memory() {
  for (const auto& [name, life] : lives_) {
    if (!life.process->wait(0ms)) memory_.note(life.process->pid());
  }
}

void Processes::note_newcomers() {
  std::vector<pid_t> living;
  for (const auto& [name, life] : lives_) {
    if (!life.process->wait(0ms)) living.push_back(life.process->pid());
  }
  (void)memory_.note_new(living);
}

std::map<std::string, SeenProcess> Processes::seen() const {
  std::map<std::string, SeenProcess> seen;
  const auto add = [&](const std::string& who) {
    const auto found = lives_.find(process_of(who));
    if (found == lives_.end()) return;
    const Life& life = found->second;
    const auto exit_code = life.process->wait(0ms);
    const char* state = exit_code ? "ended" : life.suspended ? "suspended" : "running";
    seen[who] = {state, exit_code, life.process->log(), life.process->pid()};
  };
  add("world");
  add("radio");
  for (std::uint32_t robot = 1; robot <= setup_.robots; ++robot)
    add(std::string{kRobot} + std::to_string(robot));
  return seen;
}

}  // namespace caravan::deploy
