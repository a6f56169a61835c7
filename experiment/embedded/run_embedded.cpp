// SPDX-License-Identifier: Apache-2.0
#include "experiment/embedded/run_embedded.hpp"

#include <cstdio>
#include <cstdlib>

#include "experiment/embedded/engine.hpp"
#include "experiment/embedded/stopwatch.hpp"
#include "experiment/metrics/run_record.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/controller/crash_line.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/scenario/shared_tables.hpp"
#include "runtime/trace/trace_file.hpp"
#include "world_server/physics/physics_error.hpp"

namespace caravan::experiment {
namespace {

using Clock = std::chrono::steady_clock;

/// Paces a run and notices a request to stop.
class Pace {
 public:
  Pace(runtime::Loop& loop, bool at_the_clock) : loop_{loop}, at_the_clock_{at_the_clock} {}

  /// Waits until the step at `stamp` is due. @return false when the run must stop
  [[nodiscard]] bool wait_for(Time stamp) {
    if (at_the_clock_) return loop_.wait(began_ + stamp) != runtime::Loop::Woken::kStop;
    const Clock::time_point now = Clock::now();
    if (now - asked_ < std::chrono::milliseconds{20}) return true;
    asked_ = now;
    return loop_.wait(now) != runtime::Loop::Woken::kStop;
  }
  [[nodiscard]] double wall_time_s() const {
    return std::chrono::duration<double>(Clock::now() - began_).count();
  }

 private:
  runtime::Loop& loop_;
  bool at_the_clock_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point asked_{};
};

/// The run's trace, if one was requested.
class Trace {
 public:
  explicit Trace(const RunRequest& request) {
    if (!request.trace) return;
    world_.emplace(world_trace_in(*request.trace), runtime::kWorldTrace, request.facts.robots);
    radio_.emplace(radio_trace_in(*request.trace), runtime::kRadioTrace, request.facts.robots);
  }
  void record(const Engine& engine) {
    if (!world_) return;
    world_->record(engine.world_link());
    radio_->record(engine.radio_link());
    world_->keep_up();
    radio_->keep_up();
  }

 private:
  std::optional<runtime::TraceFile> world_;
  std::optional<runtime::TraceFile> radio_;
};

}  // namespace

int run_embedded(const RunRequest& request) {
  runtime::name_crashing_controllers(runtime::kFailed);
  Engine engine{request.scenario, request.trace};
  RunRecord record{request.facts, request.folder, request.quiet ? nullptr : stdout};
  Trace trace{request};
  Pace pace{request.loop, runtime::read_experiment(request.scenario).pacing != runtime::Pacing::kFast};
  const auto so_far = [&] {
    RunEnd end;
    end.digest = engine.digest();
    end.time_split = engine.time_split();
    end.refusals = engine.refusals();
    end.wall_time_s = pace.wall_time_s();
    return end;
  };
  // The records are closed on the watch's thread while this one is kept inside the controller's step.
  const runtime::CallWatch watch{engine.calls(), [&](std::uint64_t call, runtime::CallWatch::Reason reason) {
                                   RunEnd end = so_far();
                                   const std::string what =
                                       engine.call_in_words(call) + ": " + to_text(reason);
                                   std::fprintf(stderr, "%s\n", what.c_str());
                                   end.interrupted = reason == runtime::CallWatch::Reason::kStop;
                                   if (!end.interrupted) end.failure = what;
                                   std::_Exit(record.close(end));
                                 }};
  bool stopped = false;
  bool told = false;
  std::string failure;
  try {
    while (!engine.finished() && !stopped && record.is_whole()) {
      record.observe(engine.step());
      if (!told && !engine.complaint().empty()) std::fprintf(stderr, "%s\n", engine.complaint().c_str());
      for (const std::string& warning : engine.warnings()) std::fprintf(stderr, "%s\n", warning.c_str());
      told = told || !engine.complaint().empty();
      trace.record(engine);
      record.keep_up(so_far);
      stopped = !pace.wait_for(engine.now());
    }
    record.observe(engine.last());
  } catch (const runtime::WriteError& error) {
    failure = error.what();
    record.observe(engine.last());
  } catch (const runtime::ControllerFault& fault) {
    failure = fault.what();
  } catch (const world::PhysicsError& error) {
    failure = error.what();
  }
  if (!failure.empty()) std::fprintf(stderr, "%s\n", failure.c_str());
  RunEnd end = so_far();
  end.interrupted = stopped;
  end.failure = failure;
  return record.close(end);
}

}  // namespace caravan::experiment
