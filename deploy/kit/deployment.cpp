// SPDX-License-Identifier: Apache-2.0
#include <caravan/deployment.hpp>

#include <dlfcn.h>

#include <cerrno>
#include <fstream>
#include <utility>

#include "deploy/kit/actions.hpp"
#include "deploy/kit/effective_scenario.hpp"
#include "deploy/kit/processes.hpp"
#include "deploy/kit/run_listener.hpp"
#include "runtime/bus/transport.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/pure/overload.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Kind = ProcessAction::Kind;

constexpr auto kControlPatience = 15'000ms;
constexpr auto kHoldPatience = 60'000ms;
constexpr auto kStepPatience = 30'000ms;
constexpr auto kLookPeriod = 10ms;  // longest delay until the end of a process is noticed

fs::path write_scenario(const DeploymentOptions& options) {
  fs::path file = options.folder / "scenario.toml";
  const std::string text = with_changes(options.scenario, options.changes, options.controller);
  std::ofstream out{file};
  out << text << std::flush;
  if (!out) throw runtime::StartError{runtime::cannot_write(file, errno).what()};
  return file;
}

/// The facts of a run that its tally needs.
experiment::RunFacts facts_of(const fs::path& scenario) {
  const auto document = runtime::TomlDocument::load(scenario);
  const runtime::ExperimentTable experiment = runtime::read_experiment(document);
  return {.scenario = {},
          .engine = "dds",
          .mode = {},
          .robots = runtime::read_robots(document).count,
          .items = experiment.items,
          .max_time = std::chrono::duration_cast<experiment::Time>(
              std::chrono::duration<double>(experiment.max_time_s))};
}

/// The folder of the file that holds this code: the kit's shared library, or a program. Empty: not known.
fs::path own_folder() {
  Dl_info file{};
  std::error_code error;
  if (dladdr(reinterpret_cast<const void*>(&own_folder), &file) == 0 || file.dli_fname == nullptr) return {};
  return fs::canonical(file.dli_fname, error).parent_path();
}

/// Beside the kit's library or the test, or in the folder bin beside theirs.
fs::path folder_of_binaries(const DeploymentOptions& options) {
  if (!options.binaries.empty()) return options.binaries;
  const fs::path beside_test = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {own_folder(), beside_test}) {
    for (const fs::path& place : {folder, folder.parent_path() / "bin"}) {
      if (fs::exists(place / "world_server")) return place;
    }
  }
  return beside_test;
}

runtime::Transport transport_of(const DeploymentOptions& options) {
  const std::string wrong = runtime::complaint_about_transport(options.transport);
  if (!wrong.empty()) throw runtime::StartError{"transport: " + wrong};
  return runtime::transport_named(options.transport);
}

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "nobody" : text;
}

}  // namespace

class Deployment::Parts {
 public:
  explicit Parts(DeploymentOptions options);
  ~Parts();
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  ActionResult act(const std::string& line);
  ActionResult expect(const std::string& name, const Condition& condition, std::chrono::milliseconds within);
  ActionResult step_until(const Condition& condition, std::uint64_t most);
  [[nodiscard]] Seen seen();
  [[nodiscard]] std::uint32_t domain() const { return lock_.domain(); }
  [[nodiscard]] std::uint32_t robots() const { return robots_; }
  [[nodiscard]] const fs::path& folder() const { return options_.folder; }

 private:
  ActionResult ask(const msg::ControlRequest& request);
  ActionResult hold_at(std::uint64_t step);
  [[nodiscard]] std::string scene(const Seen& seen) const;

  DeploymentOptions options_;
  runtime::Transport transport_;
  runtime::DomainLock lock_;  // before the first file: if the domain is taken, nothing is left behind
  fs::path scenario_file_;
  std::uint32_t robots_ = 0;
  Processes processes_;
  std::unique_ptr<RunListener> listener_;
  Clock::time_point noted_{};
};

Deployment::Parts::Parts(DeploymentOptions options)
    : options_{std::move(options)},
      transport_{transport_of(options_)},
      lock_{options_.domain},
      scenario_file_{write_scenario(options_)},
      robots_{runtime::read_robots(runtime::TomlDocument::load(scenario_file_)).count},
      processes_{{.run = {.binaries = folder_of_binaries(options_),
                          .agent = options_.agent,
                          .scenario = scenario_file_,
                          .domain = lock_.domain(),
                          .transport = transport_,
                          .lease_s = options_.lease_s},
                  .folder = options_.folder,
                  .robots = robots_,
                  .agents_per_process = options_.agents_per_process,
                  .awaited = RunListener::kName,
                  .arguments = options_.arguments},
                 [this](const std::string& name) {
                   if (name == "world") listener_->forget_world();
                   if (name == "radio") listener_->forget_radio();
                 }},
      listener_{std::make_unique<RunListener>(runtime::BusConfig{.role = RunListener::kName,
                                                                 .domain = lock_.domain(),
                                                                 .lease_s = options_.lease_s,
                                                                 .transport = transport_},
                                              facts_of(scenario_file_), options_.hold_start)} {}

Deployment::Parts::~Parts() {
  processes_.note_shared_memory();
  processes_.stop_all();
}

ActionResult Deployment::Parts::ask(const msg::ControlRequest& request) {
  const ControlAnswer answer = listener_->ask(request, kControlPatience);
  if (answer.is_good()) return {true, ""};
  if (answer.kind == ControlAnswer::Kind::kRefused) return {false, "refused: " + answer.reason};
  return {false, answer.reason + "\n" + scene(seen())};
}

ActionResult Deployment::Parts::hold_at(std::uint64_t step) {
  msg::ControlRequest pause;
  pause.action(msg::ControlRequest_Constants::PAUSE);
  pause.at_step(step);
  if (ActionResult asked = ask(pause); !asked.good) return asked;
  const std::string text = "state is paused and step is " + std::to_string(step);
  return expect("the world is held at step " + std::to_string(step), Condition{text}, kHoldPatience);
}

ActionResult Deployment::Parts::step_until(const Condition& condition, std::uint64_t most) {
  if (condition.asks_for("sends")) listener_->overhear();
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

ActionResult Deployment::Parts::act(const std::string& line) {
  const auto began = Clock::now();
  ActionResult result = std::visit(
      pure::Overload{[this](const ProcessAction& action) {
                       const std::string wrong = processes_.act(action);
                       return ActionResult{wrong.empty(), wrong};
                     },
                     [this](const Go&) {
                       listener_->go();
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

Seen Deployment::Parts::seen() {
  Seen seen = listener_->seen();
  seen.processes = processes_.seen();
  if (const auto world = seen.processes.find("world"); world != seen.processes.end()) {
    if (world->second.exit_code) seen.state = "absent";
  }
  return seen;
}

ActionResult Deployment::Parts::expect(const std::string& name, const Condition& condition,
                                       std::chrono::milliseconds within) {
  if (condition.asks_for("sends")) listener_->overhear();
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
    processes_.note_newcomers();
    if (Clock::now() - noted_ > 2s) {
      processes_.note_shared_memory();
      noted_ = Clock::now();
    }
    listener_->wait_for_news(kLookPeriod);
  }
}

std::string Deployment::Parts::scene(const Seen& seen) const {
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

Deployment::Deployment(DeploymentOptions options) : parts_{std::make_unique<Parts>(std::move(options))} {}
Deployment::~Deployment() = default;

ActionResult Deployment::act(const std::string& line) { return parts_->act(line); }
ActionResult Deployment::expect(const std::string& name, const Condition& condition,
                                std::chrono::milliseconds within) {
  return parts_->expect(name, condition, within);
}
ActionResult Deployment::step_until(const Condition& condition, std::uint64_t most) {
  return parts_->step_until(condition, most);
}
Seen Deployment::seen() { return parts_->seen(); }
std::uint32_t Deployment::domain() const { return parts_->domain(); }
std::uint32_t Deployment::robots() const { return parts_->robots(); }
const fs::path& Deployment::folder() const { return parts_->folder(); }

}  // namespace caravan::deploy
