// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/deployment.hpp"

#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <utility>

#include "deploy/kit/effective_scenario.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/pure/overload.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Kind = ProcessAction::Kind;

constexpr auto kStopPatience = 2000ms;
constexpr auto kKillPatience = 5000ms;
constexpr auto kControlPatience = 15'000ms;
constexpr auto kHoldPatience = 60'000ms;
constexpr auto kStepPatience = 30'000ms;
constexpr auto kLookPeriod = 10ms;  // how late the end of a process may be noticed

fs::path write_scenario(const DeploymentOptions& options) {
  fs::path file = options.folder / "scenario.toml";
  const std::string text = with_changes(options.scenario, options.changes);
  std::ofstream out{file};
  out << text << std::flush;
  if (!out) throw runtime::StartError{runtime::cannot_write(file, errno).what()};
  return file;
}

/// What the tally of a run needs to know of it.
RunFacts facts_of(const fs::path& scenario) {
  const auto document = runtime::TomlDocument::load(scenario);
  const runtime::ExperimentTable experiment = runtime::read_experiment(document);
  return {.scenario = {},
          .engine = "dds",
          .mode = {},
          .robots = runtime::read_robots(document).count,
          .items = experiment.items,
          .max_time = std::chrono::duration_cast<Time>(std::chrono::duration<double>(experiment.max_time_s))};
}

fs::path folder_of_binaries(const DeploymentOptions& options) {
  return options.binaries.empty() ? fs::read_symlink("/proc/self/exe").parent_path() : options.binaries;
}

std::string file_name(std::string name) {
  for (char& one : name) one = one == ' ' ? '_' : one;
  return name;
}

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "nobody" : text;
}

}  // namespace

Deployment::Deployment(DeploymentOptions options)
    : options_{std::move(options)},
      scenario_file_{write_scenario(options_)},
      robots_{runtime::read_robots(runtime::TomlDocument::load(scenario_file_)).count},
      lock_{options_.domain},
      memory_{lock_.domain()},
      ears_{std::make_unique<Ears>(
          runtime::BusConfig{.role = Ears::kName, .domain = lock_.domain(), .lease_s = options_.lease_s},
          facts_of(scenario_file_), options_.hold_start)} {}

Deployment::~Deployment() {
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
  lives_.clear();
}

void Deployment::start(const std::string& name) {
  const fs::path binaries = folder_of_binaries(options_);
  const bool is_robot = name.starts_with("robot ");
  std::vector<std::string> line{binaries / (is_robot          ? "robot_agent"
                                            : name == "world" ? "world_server"
                                                              : "radio_emulator"),
                                "--scenario",
                                scenario_file_,
                                "--domain",
                                std::to_string(lock_.domain()),
                                "--lease",
                                std::to_string(options_.lease_s)};
  if (name == "world") line.insert(line.end(), {"--await", Ears::kName});
  if (is_robot) line.insert(line.end(), {"--robot", name.substr(6)});
  if (const auto more = options_.arguments.find(name); more != options_.arguments.end())
    line.insert(line.end(), more->second.begin(), more->second.end());
  Life& life = lives_[name];
  const std::string number = ++life.lives == 1 ? "" : "." + std::to_string(life.lives);
  life.suspended = false;
  life.process = std::make_unique<Process>(line, options_.folder / (file_name(name) + number + ".log"));
}

bool Deployment::is_running(const std::string& name) {
  const auto found = lives_.find(name);
  return found != lives_.end() && !found->second.process->wait(0ms);
}

std::string Deployment::end(const std::string& name, int number, std::chrono::milliseconds patience) {
  Process& process = *lives_.at(name).process;
  memory_.note(process.pid());
  process.signal(number);
  process.signal(SIGCONT);
  if (!process.wait(patience))
    return name + " did not end within " + std::to_string(patience.count()) + " ms";
  if (name == "world") ears_->forget_world();
  if (name == "radio") ears_->forget_radio();
  return "";
}

std::string Deployment::signal(const std::string& name, Kind kind) {
  if (!is_running(name)) return name + " is not running";
  switch (kind) {
    case Kind::kKill:
    case Kind::kRestart:
      return end(name, SIGKILL, kKillPatience);
    case Kind::kStop:
      return end(name, SIGTERM, kStopPatience);
    case Kind::kSuspend:
      lives_.at(name).process->signal(SIGSTOP);
      lives_.at(name).suspended = true;
      return "";
    case Kind::kContinue:
      lives_.at(name).process->signal(SIGCONT);
      lives_.at(name).suspended = false;
      return "";
    case Kind::kStart:
      break;
  }
  return name + " is running already";
}

ActionResult Deployment::do_to_processes(const ProcessAction& action) {
  std::string wrong;
  const auto add = [&wrong](const std::string& text) {
    wrong += (wrong.empty() || text.empty() ? "" : "; ") + text;
  };
  if (action.kind == Kind::kKill || action.kind == Kind::kRestart) {
    // All at once, then one after the other for their ends.
    for (const std::string& name : action.names) {
      if (!is_running(name)) continue;
      memory_.note(lives_.at(name).process->pid());
      lives_.at(name).process->signal(SIGKILL);
    }
  }
  for (const std::string& name : action.names) {
    const bool starts = action.kind == Kind::kStart;
    const bool is_known = lives_.contains(name);
    if (starts && !is_running(name)) {
      start(name);
    } else if (!is_known) {
      add(name + " was never started");
    } else if (action.kind == Kind::kKill || action.kind == Kind::kRestart) {
      add(end(name, SIGKILL, kKillPatience));
    } else {
      add(signal(name, action.kind));
    }
    if (action.kind == Kind::kRestart && is_known) start(name);
  }
  return {wrong.empty(), wrong};
}

ActionResult Deployment::ask(const msg::ControlRequest& request) {
  const ControlAnswer answer = ears_->ask(request, kControlPatience);
  if (answer.is_good()) return {true, ""};
  return {false, (answer.kind == ControlAnswer::Kind::kRefused ? "refused: " : "") + answer.reason};
}

ActionResult Deployment::hold_at(std::uint64_t step) {
  msg::ControlRequest pause;
  pause.action(msg::ControlRequest_Constants::PAUSE);
  pause.at_step(step);
  if (ActionResult asked = ask(pause); !asked.good) return asked;
  const std::string text = "state is paused and step is " + std::to_string(step);
  return expect("the world is held at step " + std::to_string(step), Condition{text}, kHoldPatience);
}

ActionResult Deployment::step_until(const Condition& condition, std::uint64_t most) {
  if (condition.asks_for("sends")) ears_->overhear();
  for (std::uint64_t taken = 0; !condition.holds(seen()); ++taken) {
    const Seen now = seen();
    if (taken == most)
      return {false, "\"" + condition.text() + "\" did not hold within " + std::to_string(taken) +
                         " steps: " + condition.values(now) + "\n" + scene(now)};
    msg::ControlRequest step;
    step.action(msg::ControlRequest_Constants::STEP);
    step.steps(1);
    if (ActionResult asked = ask(step); !asked.good) return asked;
    const Condition there{"state is paused and step is " + std::to_string(now.step + 1)};
    if (ActionResult came = expect("one step", there, kStepPatience); !came.good) return came;
  }
  return {true, ""};
}

ActionResult Deployment::act(const std::string& line) {
  const auto began = Clock::now();
  ActionResult result = std::visit(
      pure::Overload{[this](const ProcessAction& action) { return do_to_processes(action); },
                     [this](const Go&) {
                       ears_->go();
                       return ActionResult{true, ""};
                     },
                     [this](const HoldAt& action) { return hold_at(action.step); },
                     [this](const StepUntil& action) { return step_until(action.condition, action.most); },
                     [this](const msg::ControlRequest& request) { return ask(request); }},
      read_action(line, robots_));
  if (!result.good) result.text = line + ": " + result.text;
  result.took_s = seconds(Clock::now() - began);
  return result;
}

void Deployment::note_shared_memory() {
  for (auto& [name, life] : lives_) {
    if (!life.process->wait(0ms)) memory_.note(life.process->pid());
  }
  noted_ = Clock::now();
}

Seen Deployment::seen() {
  Seen seen = ears_->seen();
  for (auto& [name, life] : lives_) {
    const auto exit_code = life.process->wait(0ms);
    const char* state = exit_code ? "ended" : life.suspended ? "suspended" : "running";
    seen.processes[name] = {state, exit_code, life.process->log(), life.process->pid()};
    if (name == "world" && exit_code) seen.state = "absent";
  }
  return seen;
}

ActionResult Deployment::expect(const std::string& name, const Condition& condition,
                                std::chrono::milliseconds within) {
  if (condition.asks_for("sends")) ears_->overhear();
  const auto began = Clock::now();
  for (;;) {
    const Seen now = seen();
    const double took_s = seconds(Clock::now() - began);
    if (condition.holds(now)) return {true, "", took_s};
    const bool interrupted = options_.is_interrupted && options_.is_interrupted();
    if (interrupted || Clock::now() - began >= within) {
      std::string report = name + (interrupted ? ": interrupted after " : ": not within ");
      report += std::to_string(took_s) + " s\n  expected: " + condition.text();
      report += "\n  seen: " + condition.values(now) + "\n" + scene(now);
      return {false, std::move(report), took_s};
    }
    if (Clock::now() - noted_ > 2s) note_shared_memory();
    ears_->wait_for_news(kLookPeriod);
  }
}

std::string Deployment::scene(const Seen& seen) const {
  std::string text = "  world: " + seen.state + ", session " + std::to_string(seen.sessions) + ", step " +
                     std::to_string(seen.step) + ", members " + std::to_string(seen.members) + ", items " +
                     std::to_string(seen.items) + "; missing " + listed(seen.missing) + "; hung " +
                     listed(seen.hung) + "; gone " + listed(seen.gone) + "\n  processes:";
  for (const auto& [name, process] : seen.processes) {
    text += " " + name + " " + process.state;
    if (process.exit_code) text += " " + std::to_string(*process.exit_code);
    text += ";";
  }
  text += "\n  newest events:";
  const std::size_t first = seen.events.size() > 12 ? seen.events.size() - 12 : 0;
  for (std::size_t i = first; i < seen.events.size(); ++i) text += "\n    " + seen.events[i];
  return text + "\n  logs: " + options_.folder.string();
}

}  // namespace caravan::deploy
