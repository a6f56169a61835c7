// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/rerun.hpp"

#include "experiment/metrics/text_file.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/provenance/collect.hpp"
#include "runtime/provenance/differences.hpp"
#include "runtime/provenance/sha256.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& what, const std::string& why) {
  throw runtime::StartError{what.string() + ": " + why};
}

/// Without a result, or with one that chance decides, there is nothing to compare with.
void check_result(const experiment::RecordedRun& run, const fs::path& folder) {
  if (!run.ended) refuse(folder, "the run did not reach its end: it was killed, or is still running");
  if (run.interrupted) refuse(folder, "the run was interrupted, at a moment that depends on wall time");
  if (!run.failure.empty()) refuse(folder, "the run failed: " + run.failure);
  if (run.disturbed)
    refuse(folder,
           "the run was disturbed: it lost or re-admitted a process, or was steered by `caravan ctl`, and "
           "its scenario does not say when");
}

void check_scenario_file(const experiment::RecordedRun& run, const fs::path& file) {
  const auto text = experiment::text_in(file);
  if (!text) refuse(file, "is missing: without it the run cannot be repeated");
  const std::string hash = runtime::sha256(*text);
  if (hash != run.provenance.scenario_sha256)
    refuse(file, "is not the scenario of the run: its SHA-256 is " + hash + ", that of the run was " +
                     run.provenance.scenario_sha256);
}

/// Over DDS, free pacing waits for nobody.
void check_pacing(const fs::path& scenario) {
  if (runtime::read_experiment(runtime::TomlDocument::load(scenario)).pacing == runtime::Pacing::kFree)
    refuse(scenario,
           "experiment.pacing is free: over DDS its steps depend on wall time, so no two runs are equal");
}

void check_file(const std::optional<runtime::HashedFile>& then, const std::string& role) {
  if (!then) return;
  const std::string hash = runtime::hashed(then->file).sha256;
  if (hash != then->sha256)
    refuse(then->file, "is not the " + role + " of the run: its SHA-256 is " + hash +
                           ", that of the run was " + then->sha256);
}

/// rerun-1 in the folder of the run, or the next number that is free.
fs::path new_folder_in(const fs::path& run) {
  std::error_code error;
  for (int number = 1;; ++number) {
    const fs::path folder = run / ("rerun-" + std::to_string(number));
    if (fs::symlink_status(folder, error).type() == fs::file_type::not_found) return folder;
  }
}

/// As with `caravan run --transport`.
runtime::Transport transport_of(const experiment::RecordedRun& run, const fs::path& folder) {
  const std::string why = runtime::complaint_about_transport(run.provenance.transport);
  if (!why.empty()) refuse(folder, "the transport of the run cannot be used: " + why);
  return runtime::transport_named(run.provenance.transport);
}

}  // namespace

Rerun plan_rerun(const RerunCommand& command) {
  Rerun rerun{.recorded = experiment::read_recorded_run(command.run), .run = {}};
  const experiment::RecordedRun& recorded = rerun.recorded;
  check_result(recorded, command.run);
  const fs::path scenario = command.run / "scenario.toml";
  check_scenario_file(recorded, scenario);
  check_file(recorded.provenance.controller, "controller");
  check_file(recorded.provenance.agent, "agent");
  rerun.run.scenario = scenario;
  rerun.run.embedded = command.engine.value_or(recorded.engine) == "embedded";
  if (!rerun.run.embedded || recorded.engine != "embedded") check_pacing(scenario);
  if (!rerun.run.embedded) rerun.run.transport = transport_of(recorded, command.run);
  if (recorded.provenance.agent) rerun.run.agent = recorded.provenance.agent->file;
  rerun.run.agents_per_process = recorded.provenance.agents_per_process;
  rerun.run.out = command.out ? *command.out : new_folder_in(command.run);
  std::error_code error;
  rerun.run.trace = fs::is_directory(command.run / "trace", error);
  rerun.run.quiet = command.quiet;
  rerun.run.command_line = command.command_line;
  return rerun;
}

int judge_rerun(const Rerun& rerun, std::FILE* out) {
  const experiment::RecordedRun again = experiment::read_recorded_run(*rerun.run.out);
  const experiment::RecordedRun& run = rerun.recorded;
  const bool equal = again.failure.empty() && !again.disturbed && again.digest == run.digest;
  if (equal) {
    std::fprintf(out, "equal: digest %s\n", run.digest.c_str());
  } else if (!again.failure.empty()) {
    std::fprintf(out, "differs: the repetition failed: %s\n", again.failure.c_str());
  } else if (again.disturbed) {
    std::fprintf(out, "differs: the repetition was disturbed\n");
  } else {
    std::fprintf(out, "differs: digest %s; the run had %s\n", again.digest.c_str(), run.digest.c_str());
  }
  if (again.engine != run.engine)
    std::fprintf(out, "other engine: %s; the run had %s\n", again.engine.c_str(), run.engine.c_str());
  for (const std::string& line : runtime::differences(run.provenance, again.provenance))
    std::fprintf(out, "other %s\n", line.c_str());
  return equal ? runtime::kDone : runtime::kFailed;
}

}  // namespace caravan::deploy
