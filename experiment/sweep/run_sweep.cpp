// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/run_sweep.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <map>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/text_file.hpp"
#include "experiment/sweep/quantities.hpp"
#include "experiment/sweep/run_row.hpp"
#include "experiment/sweep/sweep_folder.hpp"
#include "experiment/sweep/sweep_progress.hpp"
#include "experiment/sweep/sweep_tables.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/host/children.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Wall = std::chrono::steady_clock::time_point;

/// Longer than the second that a run over DDS gives its own processes.
constexpr auto kStopPatience = 3000ms;

double seconds_since(Wall began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

Claim claim_of(const SweepRequest& request) {
  if (request.summarise) return Claim::kSummarise;
  return request.task ? Claim::kTask : Claim::kSweep;
}

/// Runs write errors here, outside their folders, which must be empty at the start.
fs::path make_log_folder(const fs::path& folder) {
  fs::create_directories(folder / "logs");
  return folder / "logs";
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n\r ");
  if (end == std::string::npos) return "";
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return text.substr(begin, end + 1 - begin);
}

/// One sweep, task or summary, from the first check to the last line.
class Sweep {
 public:
  explicit Sweep(const SweepRequest& request)
      : request_{request},
        plan_{request.plan},
        folder_{request.folder, request.plan, claim_of(request), request.loop, request.task.value_or(0)},
        rows_(request.plan.runs.size()),
        progress_{request.quiet ? nullptr : stdout},
        children_{make_log_folder(request.folder), [&loop = request.loop] { loop.notify(); },
                  folder_.locks()} {}

  int run();

 private:
  struct Running {
    std::size_t index = 0;
    Wall began;
  };
  void look_at_all();
  void do_runs();
  void start(std::size_t index);
  void settle(const runtime::Ended& ended);
  void stop();
  /// A batch system stops a whole job at once, and a run may be the first to end.
  [[nodiscard]] bool was_interrupted_with_us(const runtime::Ended& ended) const {
    return ended.exit_code == runtime::kInterrupted &&
           request_.loop.wait(std::chrono::steady_clock::now() + 500ms) == runtime::Loop::Woken::kStop;
  }
  [[nodiscard]] std::string why(const runtime::Ended& ended) const;
  [[nodiscard]] fs::path log_of(const std::string& name) const {
    return request_.folder / "logs" / (name + ".log");
  }
  [[nodiscard]] SweepCount count() const;
  [[nodiscard]] SweepState state() const;
  void write() const;
  [[nodiscard]] int report();

  const SweepRequest& request_;
  const SweepPlan& plan_;
  SweepFolder folder_;
  std::vector<RunRow> rows_;  // same order as the runs of the plan
  std::deque<std::size_t> waiting_;
  std::map<std::string, Running> running_;  // by the name of the process
  std::size_t ended_here_ = 0;
  double ended_took_s_ = 0.0;
  bool interrupted_ = false;
  SweepProgress progress_;
  runtime::Children children_;
};

void Sweep::look_at_all() {
  for (std::size_t i = 0; i < plan_.runs.size(); ++i) {
    if (request_.task && i != *request_.task) continue;
    rows_[i] = look_at(request_.folder, plan_.runs[i]);
    const bool again = rows_[i].state == RunState::kFailed && (request_.retry_failed || request_.task);
    if (again && !request_.summarise) rows_[i] = {};
    if (rows_[i].state == RunState::kPending) waiting_.push_back(i);
  }
}

SweepCount Sweep::count() const {
  SweepCount count{.total = request_.task ? 1 : rows_.size(), .running = running_.size(), .left_s = {}};
  for (const RunRow& row : rows_) {
    count.done += row.state == RunState::kDone ? 1U : 0U;
    count.failed += row.state == RunState::kFailed ? 1U : 0U;
  }
  if (ended_here_ == 0 || (waiting_.empty() && running_.empty())) return count;
  std::vector<double> ages_s;
  for (const auto& [name, running] : running_) ages_s.push_back(seconds_since(running.began));
  const double mean_s = ended_took_s_ / static_cast<double>(ended_here_);
  count.left_s = time_left_s(mean_s, waiting_.size(), ages_s, request_.jobs);
  return count;
}

SweepState Sweep::state() const {
  const bool open = std::ranges::any_of(rows_, [](const RunRow& row) {
    return row.state == RunState::kPending || row.state == RunState::kRunning;
  });
  if (!open) return SweepState::kComplete;
  return interrupted_ || request_.summarise ? SweepState::kUnfinished : SweepState::kRunning;
}

void Sweep::write() const {
  if (!request_.task) write_tables(request_.folder, plan_, rows_, state());
}

void Sweep::start(std::size_t index) {
  const PlannedRun& run = plan_.runs[index];
  const fs::path out = request_.folder / folder_of(run);
  fs::remove_all(out);  // remains of a run that did not end
  const std::string name =
      (run.point.empty() ? "" : run.point + "_") + run.mode + "_seed_" + std::to_string(run.seed);
  std::vector<std::string> words = {fs::read_symlink("/proc/self/exe"),
                                    "run",
                                    folder_.scenario_file(),
                                    "--engine",
                                    plan_.engine,
                                    "--mode",
                                    run.mode,
                                    "--seed",
                                    std::to_string(run.seed),
                                    "--out",
                                    out,
                                    "--quiet"};
  for (std::size_t axis = 0; axis < plan_.axes.size(); ++axis) {
    words.emplace_back("--set");
    words.push_back(plan_.axes[axis] + "=" + run.values[axis]);
  }
  children_.start(name, words);
  running_[name] = {index, std::chrono::steady_clock::now()};
  rows_[index].state = RunState::kRunning;
}

std::string Sweep::why(const runtime::Ended& ended) const {
  const std::string said = last_line(text_in(log_of(ended.name)).value_or(""));
  std::string how = "exit code " + std::to_string(ended.exit_code);
  if (ended.exit_code == runtime::kInterrupted) {
    how = "interrupted by another process";
  } else if (ended.exit_code > 128) {
    how = "killed by signal " + std::to_string(ended.exit_code - 128) + " (" +
          strsignal(ended.exit_code - 128) + ")";
  }
  return said.empty() ? how : how + ": " + said;
}

void Sweep::settle(const runtime::Ended& ended) {
  const Running running = running_.at(ended.name);
  running_.erase(ended.name);
  const PlannedRun& run = plan_.runs[running.index];
  RunRow& row = rows_[running.index];
  row = look_at(request_.folder, run);
  if (row.state == RunState::kPending && !interrupted_) {
    row = {.state = RunState::kFailed, .reason = why(ended)};
    note_failure(request_.folder, run, row.reason);
  }
  std::error_code ignored;
  if (fs::is_empty(log_of(ended.name), ignored)) fs::remove(log_of(ended.name), ignored);
  if (row.state == RunState::kPending) return;
  ++ended_here_;
  ended_took_s_ += seconds_since(running.began);
  std::string line =
      (run.point.empty() ? "" : run.point + " ") + run.mode + " seed " + std::to_string(run.seed) + ": ";
  line += row.state == RunState::kDone ? "done" : "failed: " + row.reason;
  if (request_.quiet && row.state == RunState::kFailed) std::fprintf(stderr, "%s\n", line.c_str());
  progress_.say(request_.task ? line : progress_bar(count()) + "  " + line);
}

void Sweep::stop() {
  interrupted_ = true;
  children_.stop(kStopPatience);
  for (const runtime::Ended& ended : children_.ended()) settle(ended);
}

void Sweep::do_runs() {
  children_.watch();
  while (!waiting_.empty() || !running_.empty()) {
    for (; running_.size() < request_.jobs && !waiting_.empty(); waiting_.pop_front()) {
      start(waiting_.front());
    }
    progress_.show(count());
    if (request_.loop.wait(std::chrono::steady_clock::now() + 1s) == runtime::Loop::Woken::kStop) {
      return stop();
    }
    const std::vector<runtime::Ended> ended = children_.ended();
    for (const runtime::Ended& one : ended) {
      if (was_interrupted_with_us(one)) interrupted_ = true;
      settle(one);
    }
    if (interrupted_) return stop();
    if (!ended.empty()) write();
  }
}

int Sweep::report() {
  progress_.close();
  if (!request_.quiet && !request_.task) {
    std::printf("%s\nfiles       %s\n", sweep_table(plan_, rows_).c_str(), request_.folder.c_str());
    if (interrupted_) std::printf("interrupted; run the same command again to continue\n");
    std::fflush(stdout);
  }
  if (interrupted_) return runtime::kInterrupted;
  const SweepCount all = count();
  return all.done == all.total ? runtime::kDone : runtime::kFailed;
}

int Sweep::run() {
  look_at_all();
  if (!request_.quiet && !request_.task) {
    const SweepCount there = count();
    std::printf("%s: %zu runs, %zu done and %zu failed before; results in %s\n", plan_.scenario.c_str(),
                there.total, there.done, there.failed, request_.folder.c_str());
    std::fflush(stdout);
  }
  write();
  if (!request_.summarise) do_runs();
  write();
  std::error_code not_empty;
  if (!request_.task) fs::remove(request_.folder / "logs", not_empty);
  return report();
}

}  // namespace

int run_sweep(const SweepRequest& request) {
  if (request.task && *request.task >= request.plan.runs.size()) {
    throw runtime::StartError{"--task-index " + std::to_string(*request.task) + ": the sweep has " +
                              std::to_string(request.plan.runs.size()) + " runs, counted from 0"};
  }
  return Sweep{request}.run();
}

}  // namespace caravan::experiment
