// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/run_script.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <vector>

#include <caravan/deployment.hpp>
#include "deploy/kit/actions.hpp"
#include "deploy/kit/effective_scenario.hpp"
#include "deploy/kit/junit.hpp"
#include "deploy/kit/quantities.hpp"
#include "deploy/kit/script.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;

fs::path make_folder(const ScriptRequest& request) {
  fs::path folder;
  if (request.out) {
    folder = *request.out;
  } else {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    std::array<char, 32> time{};
    std::strftime(time.data(), time.size(), "-%Y%m%d-%H%M%S", &local);
    folder = fs::path{"deployments"} / (request.script.stem().string() + time.data());
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw runtime::StartError{folder.string() + ": " + error.message()};
  if (!fs::is_empty(folder)) throw runtime::StartError{folder.string() + ": is not empty"};
  return fs::absolute(folder);
}

ActionResult run_step(Deployment& deployment, const ScriptStep& step) {
  ActionResult result{true, ""};
  double took_s = 0.0;
  const auto go_on = [&](const ActionResult& next) {
    result = next;
    took_s += next.took_s;
    return result.good;
  };
  const bool acted = [&] {
    if (step.at_step && !go_on(deployment.act("hold_at " + std::to_string(*step.at_step)))) return false;
    if (step.when && !go_on(deployment.expect(step.name + " (when)", *step.when, step.within))) return false;
    for (const std::string& action : step.actions) {
      if (!go_on(deployment.act(action))) return false;
    }
    return true;
  }();
  if (acted && step.expectation) go_on(deployment.expect(step.name, *step.expectation, step.within));
  result.took_s = took_s;
  return result;
}

void print(const Verdict& verdict) {
  const char* mark = verdict.kind == Verdict::Kind::kGood     ? "ok     "
                     : verdict.kind == Verdict::Kind::kFailed ? "FAILED "
                                                              : "skipped";
  std::printf("%s %s (%.1f s)\n%s", mark, verdict.name.c_str(), verdict.took_s,
              verdict.text.empty() ? "" : (verdict.text + "\n").c_str());
  std::fflush(stdout);
}

}  // namespace

int run_script(const ScriptRequest& request, runtime::Loop& loop) {
  const Script script = load_script(request.script, request.settings);
  if (request.check_only) {
    std::printf("%s: valid, %zu steps\n", request.script.c_str(), script.steps.size());
    return runtime::kDone;
  }
  const fs::path folder = make_folder(request);
  const auto is_interrupted = [&loop] {
    return loop.wait(std::chrono::steady_clock::now()) == runtime::Loop::Woken::kStop;
  };
  std::vector<Verdict> verdicts;
  bool good = true;
  {
    Deployment deployment{{.scenario = script.scenario,
                           .changes = with_settings(script.changes, script.settings),
                           .controller = request.controller,
                           .folder = folder,
                           .domain = request.domain,
                           .transport = to_text(request.transport),
                           .lease_s = script.lease_s,
                           .agents_per_process = script.agents_per_process,
                           .hold_start = script.hold_start,
                           .is_interrupted = is_interrupted}};
    if (!request.quiet) std::printf("DDS domain %u, logs in %s\n", deployment.domain(), folder.c_str());
    for (const ScriptStep& step : script.steps) {
      Verdict verdict{step.name, Verdict::Kind::kSkipped, "", 0.0};
      if (good && !is_interrupted()) {
        const ActionResult result = run_step(deployment, step);
        good = result.good;
        verdict.kind = good ? Verdict::Kind::kGood : Verdict::Kind::kFailed;
        verdict.text = result.text;
        verdict.took_s = result.took_s;
      }
      if (!request.quiet || verdict.kind == Verdict::Kind::kFailed) print(verdict);
      verdicts.push_back(std::move(verdict));
    }
  }
  const fs::path report = request.junit.value_or(folder / "junit.xml");
  std::ofstream out{report};
  out << to_junit(script.name, verdicts) << std::flush;
  if (!out) throw runtime::cannot_write(report, errno);
  if (is_interrupted()) return runtime::kInterrupted;
  return good ? runtime::kDone : runtime::kConditionNotMet;
}

std::string script_help() {
  std::string text = "Actions:\n";
  for (const ActionForm& form : action_forms())
    text += "  " + std::string{form.form} + "  " + std::string{form.meaning} + "\n";
  for (const ControlForm& form : control_forms())
    text += "  " + std::string{form.form} + "  " + std::string{form.meaning} + "\n";
  text += "Expectations are about (is, is not, <, <=, >, >=, has, lacks; joined by and):\n";
  for (const QuantityForm& form : quantity_forms())
    text += "  " + std::string{form.form} + "  " + std::string{form.meaning} + "\n";
  return text;
}

}  // namespace caravan::deploy
