// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/run_dds.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>

#include "deploy/launcher/last_error.hpp"
#include "deploy/launcher/run_commands.hpp"
#include "deploy/launcher/standstill.hpp"
#include "deploy/observer/observer.hpp"
#include "deploy/observer/run_end.hpp"
#include "experiment/metrics/run_record.hpp"
#include "idl/stamp.hpp"
#include "runtime/host/children.hpp"
#include "runtime/host/shared_memory.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

using namespace std::chrono_literals;
using Wall = std::chrono::steady_clock::time_point;
namespace msg = caravan_interfaces::msg;

const std::string kObserverName = "launcher";
constexpr auto kStopPatience = 1000ms;
constexpr auto kLookPeriod = 250ms;
constexpr auto kStartPeriod = 50ms;  // the same while some processes have not joined the bus
constexpr auto kNotePeriod = 2s;     // of all shared memory, while they are starting
constexpr auto kNotePeriodLater = 10s;

/// Whether there is no room for the next lines of a log.
bool is_full(const std::filesystem::path& folder) {
  std::error_code error;
  const auto space = std::filesystem::space(folder, error);
  return !error && space.available < 4096;
}

/// One run over DDS, from the first process to the last.
class DdsRun {
 public:
  explicit DdsRun(const experiment::RunRequest& request)
      : request_{request},
        experiment_{runtime::read_experiment(request.scenario)},
        memory_{request.domain},
        observer_{bus_config(), kObserverName, request.facts.robots, request.loop},
        record_{request.facts, request.folder, request.quiet ? nullptr : stdout},
        children_{log_folder(), [&loop = request.loop] { loop.notify(); }} {}

  int run();

 private:
  [[nodiscard]] double lease_s() const { return experiment_.pacing == runtime::Pacing::kFree ? 1.0 : 5.0; }
  [[nodiscard]] runtime::BusConfig bus_config() const {
    return {.role = kObserverName,
            .domain = request_.domain,
            .lease_s = lease_s(),
            .transport = request_.transport};
  }
  [[nodiscard]] std::filesystem::path log_folder() const {
    std::filesystem::create_directories(request_.folder / "logs");
    return request_.folder / "logs";
  }
  void start_everybody();
  /// Runs until the run is decided, interrupted or lost.
  void follow();
  void look();
  /// Handles a process that ended by itself. Before the first step the run fails at once: no other process
  /// takes its place. It could not start then, unless the world has failed in that step.
  void take_end(const runtime::Ended& one);
  /// Names agents that ended by themselves and whose ends have not been handled: shortly before the run's
  /// end.
  /// @param killed  names of processes that did not stop; null: none has been told to stop yet
  void name_lost_agents(const std::vector<std::string>* killed);
  [[nodiscard]] std::string error_of(const runtime::Ended& one) const {
    return last_error_of(request_.folder / "logs" / (one.name + ".log"));
  }
  /// Process, way of its end, and its own reason.
  [[nodiscard]] std::string in_words(const runtime::Ended& one) const;
  void check_start(Wall now);
  [[nodiscard]] bool have_last_statuses() const;
  [[nodiscard]] experiment::RunEnd so_far() const;

  const experiment::RunRequest& request_;
  runtime::ExperimentTable experiment_;
  runtime::SharedMemory memory_;
  Observer observer_;
  experiment::RunRecord record_;
  runtime::Children children_;
  Wall began_ = std::chrono::steady_clock::now();
  Wall segments_noted_{};
  Standstill standstill_{began_};
  bool decided_ = false;
  bool stepped_ = false;
  std::size_t agent_processes_ = 0;
  bool radio_ended_ = false;
  bool lost_a_process_ = false;  // in the run; the world may not have noticed it before the run ends
  std::string failure_;
  bool could_not_start_ = false;
  bool interrupted_ = false;
  Observer::News newest_;
};

void DdsRun::start_everybody() {
  if (!request_.quiet) {
    std::printf("DDS domain %u, logs in %s\n", request_.domain, (request_.folder / "logs").c_str());
    std::fflush(stdout);
  }
  const RunSetup setup{.binaries = std::filesystem::read_symlink("/proc/self/exe").parent_path(),
                       .agent = request_.agent,
                       .scenario = request_.scenario_file,
                       .domain = request_.domain,
                       .transport = request_.transport,
                       .lease_s = lease_s()};
  std::vector<std::string> world = world_command(setup, kObserverName);
  std::vector<std::string> radio = radio_command(setup);
  if (request_.trace) {
    world.insert(world.end(), {"--trace", experiment::world_trace_in(*request_.trace)});
    radio.insert(radio.end(), {"--trace", experiment::radio_trace_in(*request_.trace)});
  }
  children_.start("world_server", world);
  children_.start("radio_emulator", radio);
  for (const RobotGroup& group : groups_of(request_.facts.robots, request_.agents_per_process)) {
    std::vector<std::string> agent = agent_command(setup, to_text(group));
    // Another program knows the common options only.
    if (request_.trace && request_.agent.empty()) agent.insert(agent.end(), {"--trace", *request_.trace});
    children_.start("robot_agent_" + to_text(group), agent);
    ++agent_processes_;
  }
  children_.watch();
}

void DdsRun::look() {
  const std::uint64_t heard = newest_.world_statuses;
  newest_ = observer_.look();
  const Wall now = std::chrono::steady_clock::now();
  if (newest_.world_statuses != heard) standstill_.note_world(now);
  if (!newest_.observations.empty()) standstill_.note_step(now);
  for (const experiment::Observation& observation : newest_.observations) record_.observe(observation);
  if (!newest_.observations.empty()) {
    stepped_ = true;
    observer_.give_credit(newest_.observations.back().stamp);
  }
  decided_ = decided_ || newest_.last_seen;
  record_.keep_up([this] { return so_far(); });
}

std::string DdsRun::in_words(const runtime::Ended& one) const {
  std::string text = one.name + " (pid " + std::to_string(one.pid) + ") " + runtime::how(one);
  if (const std::string error = error_of(one); !error.empty()) text += ": " + error;
  if (is_full(request_.folder)) text += "; no space is left in " + request_.folder.string();
  return text;
}

void DdsRun::name_lost_agents(const std::vector<std::string>* killed) {
  for (const runtime::Ended& one : children_.ended()) {
    if (!one.name.starts_with("robot_agent")) continue;
    bool is_lost = one.exit_code != runtime::kDone;
    if (killed != nullptr) {
      // Other programs may end in other ways when they are stopped, and so may one that has just started.
      const bool was_killed = std::ranges::find(*killed, one.name) != killed->end();
      is_lost = is_lost && one.exit_code != 128 + SIGTERM && !was_killed && request_.agent.empty();
      // A controller in a call that does not return ends with success when its process is stopped.
      is_lost = is_lost || (!was_killed && error_of(one).starts_with("controller "));
    }
    if (is_lost) std::fprintf(stderr, "%s\n", in_words(one).c_str());
  }
}

void DdsRun::take_end(const runtime::Ended& one) {
  const std::string how = in_words(one);
  if (!stepped_) {
    if (!failure_.empty()) return;  // the first of several
    failure_ = how + ", and the run had not begun";
    could_not_start_ = one.name != "world_server" || one.exit_code != runtime::kFailed;
  } else if (one.name.starts_with("robot_agent")) {
    lost_a_process_ = lost_a_process_ || !decided_;
    --agent_processes_;
    std::fprintf(stderr, "%s\n", how.c_str());
    if (agent_processes_ == 0) failure_ = "every agent has ended; the last was " + how;
  } else if (one.name == "world_server" || (request_.trace && one.exit_code == runtime::kFailed)) {
    failure_ = how;  // without its radio's part a trace is useless
  } else {
    lost_a_process_ = lost_a_process_ || !decided_;
    radio_ended_ = true;
    std::fprintf(stderr, "%s; the robots continue without it\n", how.c_str());
  }
}

void DdsRun::check_start(Wall now) {
  if (stepped_ || now - began_ < std::chrono::duration<double>(experiment_.start_timeout_s)) return;
  failure_ =
      "not started within " + std::to_string(static_cast<int>(experiment_.start_timeout_s)) + " s, missing:";
  if (!newest_.world) failure_ += " world_server";
  if (newest_.world) {
    for (const std::string& name : newest_.world->missing()) failure_ += " " + name;
  }
  could_not_start_ = true;
}

void DdsRun::follow() {
  bool all_joined = false;
  while (!decided_ && failure_.empty() && record_.is_whole()) {
    const Wall now = std::chrono::steady_clock::now();
    if (request_.loop.wait(now + (all_joined ? Wall::duration{kLookPeriod} : kStartPeriod)) ==
        runtime::Loop::Woken::kStop) {
      interrupted_ = true;
      return;
    }
    look();
    for (const runtime::Ended& one : children_.ended()) take_end(one);
    check_start(now);
    if (const auto why = standstill_.say(now, newest_.world)) std::fprintf(stderr, "%s\n", why->c_str());
    if (const auto why = standstill_.give_up(now, newest_.world); why && failure_.empty()) failure_ = *why;
    if (!all_joined) all_joined = memory_.note_new(children_.running()) || stepped_;
    if (now - segments_noted_ > (stepped_ ? kNotePeriodLater : kNotePeriod)) {
      for (const pid_t pid : children_.running()) memory_.note(pid);
      segments_noted_ = now;
    }
  }
  // The deciding truth arrives first, then the statuses with the digest and the final counts.
  const Wall patience = std::chrono::steady_clock::now() + 10s;
  while (decided_ && std::chrono::steady_clock::now() < patience) {
    if (have_last_statuses()) return;
    if (request_.loop.wait(patience) == runtime::Loop::Woken::kStop) return;
    look();
  }
}

bool DdsRun::have_last_statuses() const {
  if (!newest_.world || newest_.world->state() != msg::WorldStatus_Constants::FINISHED) return false;
  return !newest_.radio || radio_ended_ ||
         idl::to_time(newest_.radio->stamp()) >= idl::to_time(newest_.world->stamp());
}

experiment::RunEnd DdsRun::so_far() const {
  experiment::RunEnd end = run_end(newest_.world, newest_.radio, newest_.agents_compute_s);
  end.disturbed = end.disturbed || lost_a_process_;
  end.strangers = newest_.strangers;
  end.interrupted = interrupted_;
  end.failure = failure_;
  return end;
}

int DdsRun::run() {
  start_everybody();
  follow();
  const bool names_lost = stepped_ && failure_.empty() && !interrupted_;
  if (names_lost) name_lost_agents(nullptr);
  const std::vector<std::string> killed = children_.stop(kStopPatience);
  for (const std::string& name : killed) {
    std::fprintf(stderr, "%s did not stop within 1 s and was killed\n", name.c_str());
  }
  if (names_lost) name_lost_agents(&killed);
  look();
  if (!failure_.empty()) std::fprintf(stderr, "%s\n", failure_.c_str());
  const int code = record_.close(so_far());
  return could_not_start_ ? static_cast<int>(runtime::kCouldNotStart) : code;
}

}  // namespace

int run_dds(const experiment::RunRequest& request) { return DdsRun{request}.run(); }

}  // namespace caravan::deploy
