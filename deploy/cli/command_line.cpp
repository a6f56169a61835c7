// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>

#include "runtime/process/run_process.hpp"
#include "runtime/process/version.hpp"

namespace caravan::deploy {
namespace {

void add_run_options(CLI::App& run, RunCommand& command, std::string& engine) {
  run.add_option("scenario", command.scenario, "Scenario file (TOML)")->required();
  run.add_option("--engine", engine, "dds: a process for each part; embedded: all in this process")
      ->check(CLI::IsMember({"dds", "embedded"}))
      ->capture_default_str();
  run.add_option("--mode", command.overrides.mode, "Communication: none, partial or full")
      ->check(CLI::IsMember({"none", "partial", "full"}));
  run.add_option("--seed", command.overrides.seed, "Seed of everything random")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{std::numeric_limits<std::int64_t>::max()}));
  run.add_option("--robots", command.overrides.robots, "Number of robots");
  run.add_option("--items", command.overrides.items, "Deliveries that end the run; 0: it ends with the time");
  run.add_option("--max-time", command.overrides.max_time_s, "Simulated seconds after which the run ends");
  run.add_option("--pacing", command.overrides.pacing, "fast, realtime or free")
      ->check(CLI::IsMember({"fast", "realtime", "free"}));
  run.add_option("--domain", command.domain, "DDS domain; without it a free one is taken")
      ->check(CLI::Range(0U, 232U));
  run.add_option("--out", command.out, "Folder for the results; must be new or empty");
  run.add_flag("--quiet", command.quiet, "No progress, no result table");
}

Exit explain(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return {app.exit(error)};
  std::fprintf(stderr, "caravan: %s (see caravan --help)\n", error.what());
  return {runtime::kCouldNotStart};
}

}  // namespace

std::variant<CheckCommand, RunCommand, Exit> read_command_line(int argc, const char* const* argv) {
  CLI::App app{"Runs swarms of transporting robots: agents, emulated world, emulated radio", "caravan"};
  app.set_version_flag("--version", "caravan " + std::string{runtime::kVersion});
  app.require_subcommand(1);
  RunCommand run_command;
  std::string engine = "dds";
  CLI::App* run = app.add_subcommand("run", "Run a scenario and report its result");
  add_run_options(*run, run_command, engine);
  CheckCommand check_command;
  CLI::App* check = app.add_subcommand("check", "Check a scenario file and run nothing");
  check->add_option("scenario", check_command.scenario, "Scenario file (TOML)")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explain(app, error);
  }
  run_command.embedded = engine == "embedded";
  if (check->parsed()) return check_command;
  return run_command;
}

}  // namespace caravan::deploy
