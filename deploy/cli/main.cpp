// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <new>

#include "deploy/cli/check_scenario.hpp"
#include "deploy/cli/command_line.hpp"
#include "deploy/cli/new_project.hpp"
#include "deploy/cli/plan_sweep.hpp"
#include "deploy/cli/rerun.hpp"
#include "deploy/cli/run_provenance.hpp"
#include "deploy/cli/try_controllers.hpp"
#include "deploy/control/run_ctl.hpp"
#include "deploy/doctor/run_doctor.hpp"
#include "deploy/kit/run_script.hpp"
#include "deploy/kit/script.hpp"
#include "deploy/launcher/run_dds.hpp"
#include "experiment/embedded/run_embedded.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "experiment/report/write_report.hpp"
#include "experiment/report/write_statistics.hpp"
#include "experiment/sweep/run_sweep.hpp"
#include "experiment/trace/diff_runs.hpp"
#include "experiment/trace/step_agent.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/process/streams.hpp"
#include "runtime/provenance/provenance_json.hpp"
#include "runtime/pure/one_line.hpp"

namespace {

using namespace caravan;

int check(const deploy::CheckCommand& command) {
  (void)deploy::check_scenario(
      runtime::TomlDocument::load(command.scenario, deploy::read_settings(command.sets, {})));
  std::printf("%s: good\n", command.scenario.c_str());
  return runtime::kDone;
}

int write_new(const deploy::NewCommand& command) {
  for (const auto& file :
       deploy::write_project(command.name, runtime::data_folder() / "templates" / "my_swarm"))
    std::printf("%s\n", file.c_str());
  std::printf("Next: cd %s, and do what its README.md says.\n", command.name.c_str());
  return runtime::kDone;
}

/// Writes a file before the run begins; a failure is an error of the start.
void write_first_file(const std::filesystem::path& file, const std::string& text) {
  try {
    experiment::write_whole_file(file, text);
  } catch (const runtime::WriteError& error) {
    throw runtime::StartError{error.what()};
  }
}

/// @throws runtime::StartError when it cannot be used
std::filesystem::path agent_program(const deploy::RunCommand& command) {
  if (command.agent.empty()) return {};
  if (command.embedded) throw runtime::StartError{"--agent starts processes: it needs --engine dds"};
  if (access(command.agent.c_str(), X_OK) != 0)
    throw runtime::StartError{"--agent: " + command.agent + " is not executable: chmod +x it"};
  return std::filesystem::absolute(command.agent).lexically_normal();
}

int run(const deploy::RunCommand& command) {
  runtime::Loop loop;
  const auto original =
      runtime::TomlDocument::load(command.scenario, deploy::read_settings(command.sets, command.overrides));
  (void)deploy::check_tables(
      original, deploy::controller_of(
                    original, command.overrides));  // first, because only the original has the line numbers
  const std::string text = deploy::effective_text(original, command.overrides);
  const auto effective =
      runtime::TomlDocument::parse(text, command.scenario.string() + " with the command line's changes");
  experiment::RunFacts facts = deploy::check_scenario(effective);
  facts.engine = command.embedded ? "embedded" : "dds";
  const std::filesystem::path agent = agent_program(command);
  if (!agent.empty()) facts.controller = agent.filename();
  facts.provenance = deploy::provenance_of(command, effective, text, agent);
  std::optional<runtime::DomainLock>
      lock;  // before the folder: if the domain is taken, nothing is left behind
  if (!command.embedded) lock.emplace(command.domain);
  const auto folder = std::filesystem::absolute(experiment::make_run_directory(command.out, facts));
  write_first_file(folder / "scenario.toml", text);
  std::optional<std::filesystem::path> trace;
  if (command.trace) {
    trace = folder / "trace";
    std::filesystem::create_directory(*trace);
    write_first_file(*trace / "provenance.json", runtime::record_header(facts.provenance, text));
  }
  const experiment::RunRequest request{.facts = facts,
                                       .scenario = effective,
                                       .folder = folder,
                                       .scenario_file = folder / "scenario.toml",
                                       .domain = lock ? lock->domain() : 0,
                                       .transport = command.transport,
                                       .agent = agent,
                                       .agents_per_process = command.agents_per_process,
                                       .trace = trace,
                                       .quiet = command.quiet,
                                       .loop = loop};
  const int code = command.embedded ? experiment::run_embedded(request) : deploy::run_dds(request);
  if (command.report && code != runtime::kInterrupted) (void)experiment::write_report({folder}, std::nullopt);
  return code;
}

int rerun(const deploy::RerunCommand& command) {
  const deploy::Rerun plan = deploy::plan_rerun(command);
  const int code = run(plan.run);
  // A run whose time is up ends with kFailed, and has a result.
  if (code != runtime::kDone && code != runtime::kFailed) return code;
  return deploy::judge_rerun(plan, stdout);
}

int sweep(const deploy::SweepCommand& command) {
  runtime::Loop loop;
  experiment::SweepPlan plan = deploy::plan_sweep(command);
  if (command.count) {
    std::printf("%zu\n", plan.runs.size());
    return runtime::kDone;
  }
  const std::filesystem::path folder = std::filesystem::absolute(command.out);
  const int code = experiment::run_sweep({.plan = std::move(plan),
                                          .folder = folder,
                                          .jobs = command.jobs,
                                          .task = command.task,
                                          .summarise = command.summarise,
                                          .retry_failed = command.retry_failed,
                                          .quiet = command.quiet,
                                          .loop = loop});
  if (command.task) return code;
  if (code == runtime::kInterrupted) {
    experiment::remove_comparisons(folder);
    return code;
  }
  return experiment::write_statistics(folder, command.quiet, loop) ? runtime::kInterrupted : code;
}

/// Whether somebody may type at the prompt of a debugger: standard input is a terminal, and this process may
/// read from it.
bool can_be_debugged() { return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp(); }

int obey(const deploy::Exit& exit) { return exit.code; }
int obey(const deploy::CheckCommand& command) { return check(command); }
int obey(const deploy::NewCommand& command) { return write_new(command); }
int obey(const deploy::RunCommand& command) { return run(command); }
int obey(const deploy::RerunCommand& command) { return rerun(command); }
int obey(const deploy::DiffCommand& command) {
  return experiment::diff_runs(command.one, command.other, stdout);
}
int obey(const deploy::StepAgentCommand& command) {
  const auto scenario = runtime::TomlDocument::load(command.scenario.value_or(command.run / "scenario.toml"));
  deploy::Overrides overrides;
  overrides.controller = command.controller;
  const std::string controller = deploy::controller_of(scenario, overrides);
  const bool has_deadline = !can_be_debugged();
  // In a process of its own, which a debugger does not reach.
  if (has_deadline) (void)deploy::try_controllers(scenario, controller);
  return experiment::step_agent({.run = command.run,
                                 .robot = command.robot,
                                 .scenario = scenario,
                                 .controller = controller,
                                 .step = command.step,
                                 .has_deadline = has_deadline},
                                stdout);
}
int obey(const deploy::SweepCommand& command) { return sweep(command); }
int obey(const deploy::ReportCommand& command) {
  return experiment::write_report(command.folders, command.out);
}
int obey(const deploy::CtlCommand& command) {
  return deploy::run_ctl(command.domain, command.transport, command.words);
}
int obey(const deploy::DoctorCommand& command) {
  return deploy::run_doctor({.robots = command.robots,
                             .domain = command.domain,
                             .transport = command.transport,
                             .clean = command.clean});
}
int obey(const deploy::DeployCommand& command) {
  runtime::Loop loop;
  deploy::Overrides overrides;
  if (!command.controller.empty()) overrides.controller = command.controller;
  const runtime::Settings settings = deploy::read_settings(command.sets, overrides);
  const std::string controller = deploy::absolute_controller(command.controller);
  if (!settings.empty()) {
    const auto scenario = deploy::scenario_of(deploy::load_script(command.script, settings), controller);
    (void)deploy::check_tables(scenario, deploy::controller_of(scenario, {}));
  }
  return deploy::run_script({.script = command.script,
                             .out = command.out,
                             .junit = command.junit,
                             .controller = controller,
                             .settings = settings,
                             .domain = command.domain,
                             .transport = command.transport,
                             .check_only = command.check_only,
                             .quiet = command.quiet},
                            loop);
}

}  // namespace

int main(int argc, char** argv) {
  runtime::prepare_streams();
  try {
    return runtime::with_output_written(
        std::visit([](const auto& command) { return obey(command); }, deploy::read_command_line(argc, argv)));
  } catch (const runtime::StartError& error) {
    std::fprintf(stderr, "%s\n", pure::one_line(error.what()).c_str());
    return runtime::kCouldNotStart;
  } catch (const deploy::Interrupted&) {
    std::fprintf(stderr, "caravan: stopped while it tried the controllers; nothing has started\n");
    return runtime::kInterrupted;
  } catch (const runtime::WriteError& error) {
    std::fprintf(stderr, "%s\n", pure::one_line(error.what()).c_str());
    return runtime::kFailed;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "%s: %s\n", error.path1().c_str(), error.code().message().c_str());
    return runtime::kFailed;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "caravan: not enough memory for this\n");
    return runtime::kFailed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "caravan: ended by an unexpected error: %s\n", pure::one_line(error.what()).c_str());
    return runtime::kFailed;
  }
}
