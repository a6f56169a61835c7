// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/step_agent.hpp"

#include <atomic>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <vector>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/observation.hpp"
#include "experiment/trace/compare.hpp"
#include "experiment/trace/step_text.hpp"
#include "experiment/trace/trace_reader.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/controller/crash_line.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/scenario/shared_tables.hpp"
#include "runtime/trace/trace_file.hpp"

namespace caravan::experiment {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::filesystem::path trace_of(const StepAgentRequest& request) {
  const std::uint32_t robots = runtime::read_robots(request.scenario).count;
  if (request.robot < 1 || request.robot > robots) {
    throw runtime::StartError{request.run.string() + ": has no robot " + std::to_string(request.robot) +
                              ", its robots are 1 to " + std::to_string(robots)};
  }
  return runtime::robot_trace_in(request.run / "trace", request.robot);
}

/// One robot's part of a trace: what its controller was given and, unless it failed, what it answered.
class RobotTrace {
 public:
  /// @throws runtime::StartError when the file is no trace, or that of another robot
  RobotTrace(const std::filesystem::path& file, std::uint32_t robot) : reader_{file, runtime::kRobotTrace} {
    if (reader_.number() != robot)
      throw runtime::StartError{file.string() + ": is the trace of robot " +
                                std::to_string(reader_.number()) + ", not of robot " + std::to_string(robot)};
  }

  /// @return false: no whole record is left
  [[nodiscard]] bool next_inputs(caravan::Inputs& inputs) { return next(inputs, read_inputs); }
  [[nodiscard]] bool next_answer(caravan::Outputs& answer) { return next(answer, read_outputs); }
  [[nodiscard]] bool cut_off() const { return reader_.cut_off(); }

 private:
  template <typename Value>
  bool next(Value& value, Value (*read)(std::span<const std::uint8_t>)) {
    if (!reader_.next(bytes_)) return false;
    ++records_;
    try {
      value = read(bytes_);
    } catch (const std::runtime_error& error) {
      throw runtime::StartError{reader_.file().string() + ": is damaged in step " +
                                std::to_string((records_ + 1) / 2) + ": " + error.what()};
    }
    return true;
  }

  TraceReader reader_;
  Bytes bytes_;
  std::uint64_t records_ = 0;  // two for each step
};

/// The controller that is compared, with faults that end the comparison.
class Candidate {
 public:
  explicit Candidate(const StepAgentRequest& request)
      : controllers_{request.scenario, request.controller},
        config_{agent::load_config(request.scenario, request.robot)},
        controller_{controllers_.make_guarded(config_)} {
    if (!request.has_deadline) return;
    watch_.emplace(calls_,
                   [this](std::uint64_t call, runtime::CallWatch::Reason reason) { give_up(call, reason); });
  }

  /// @throws runtime::StartError when it fails
  [[nodiscard]] caravan::Outputs step(const caravan::Inputs& inputs) {
    now_ = inputs.now;
    const runtime::Calls::Call call{calls_};
    try {
      return controller_.step(inputs);
    } catch (const runtime::ControllerFault& fault) {
      throw runtime::StartError{fault.what()};
    }
  }
  [[nodiscard]] const std::string& name() const { return controllers_.name(); }
  /// A trace does not have it.
  void add_destination(caravan::Inputs& inputs) const {
    inputs.destination = controllers_.destination_in_sight(inputs.sensors, config_);
  }

 private:
  [[noreturn]] void give_up(std::uint64_t call, runtime::CallWatch::Reason reason) const {
    std::fprintf(stderr, "controller %s, robot %u, step %llu (%s s): %s\n", name().c_str(),
                 unsigned{config_.id.value}, static_cast<unsigned long long>(call / 2 + 1),
                 fixed(in_seconds(now_), 3).c_str(), to_text(reason).c_str());
    std::_Exit(runtime::kCouldNotStart);
  }

  agent::Controllers controllers_;
  agent::Config config_;
  runtime::GuardedController controller_;
  std::atomic<caravan::Time> now_{};  // of the step that is called
  runtime::Calls calls_;
  std::optional<runtime::CallWatch> watch_;
};

/// The beginning of the lines about a step.
std::string step_in_words(std::uint64_t step, caravan::Time now, std::uint32_t robot) {
  return "step " + std::to_string(step) + " (" + fixed(in_seconds(now), 3) + " s): robot " +
         std::to_string(robot);
}

void tell(const std::string& step, const std::vector<Difference>& found, std::FILE* out) {
  std::string text = step;
  for (const Difference& one : found)
    text += (&one == &found.front() ? " " : "; ") + one.quantity + ": " + one.one + " | " + one.other;
  std::fprintf(out, "%s\n", text.c_str());
}

/// The last step of the comparison when one is wanted. @return the exit code
int show(RobotTrace& trace, Candidate& candidate, const caravan::Inputs& inputs,
         const StepAgentRequest& request, std::FILE* out) {
  // First, for a controller that fails in this step.
  std::fprintf(out, "%s was given\n%s", step_in_words(*request.step, inputs.now, request.robot).c_str(),
               text_of(inputs).c_str());
  std::fflush(out);
  caravan::Outputs recorded;
  const bool is_whole = trace.next_answer(recorded);
  std::fprintf(out, "answer in the run\n%s", is_whole ? text_of(recorded).c_str() : "  none\n");
  std::fflush(out);
  const caravan::Outputs answer = candidate.step(inputs);
  std::fprintf(out, "answer of controller %s\n%s", candidate.name().c_str(), text_of(answer).c_str());
  return is_whole && differences(request.robot, recorded, answer).empty() ? 0 : 1;
}

}  // namespace

int step_agent(const StepAgentRequest& request, std::FILE* out) {
  runtime::name_crashing_controllers(runtime::kCouldNotStart);
  const std::filesystem::path file = trace_of(request);
  RobotTrace trace{file, request.robot};
  Candidate candidate{request};
  caravan::Inputs inputs;
  caravan::Outputs recorded;
  std::uint64_t steps = 0;
  while (trace.next_inputs(inputs)) {
    candidate.add_destination(inputs);
    if (request.step == steps + 1) return show(trace, candidate, inputs, request, out);
    const caravan::Outputs answer = candidate.step(inputs);
    // Here the run was killed, or its controller failed. The step was taken nevertheless: this one might fail
    // as well.
    if (!trace.next_answer(recorded)) {
      std::fprintf(out, "%s: has no answer to step %llu\n", file.c_str(),
                   static_cast<unsigned long long>(steps + 1));
      break;
    }
    ++steps;
    if (request.step) continue;
    const auto found = differences(request.robot, recorded, answer);
    if (found.empty()) continue;
    tell(step_in_words(steps, inputs.now, request.robot), found, out);
    return 1;
  }
  if (steps == 0) throw runtime::StartError{file.string() + ": has no whole step"};
  if (request.step) {
    throw runtime::StartError{file.string() + ": has no step " + std::to_string(*request.step) +
                              ", its steps are 1 to " + std::to_string(steps)};
  }
  if (trace.cut_off())
    std::fprintf(out, "%s: is incomplete after step %llu\n", file.c_str(),
                 static_cast<unsigned long long>(steps));
  std::fprintf(out, "equal: robot %u, controller %s, %llu steps\n", request.robot, candidate.name().c_str(),
               static_cast<unsigned long long>(steps));
  return 0;
}

}  // namespace caravan::experiment
