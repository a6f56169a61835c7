// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <thread>

#include "deploy/control/run_ctl.hpp"
#include "deploy/kit/run_script.hpp"
#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/process/version.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::deploy {
namespace {

/// Error for a name of a file or folder; empty: none.
std::string complaint_about_name(const std::string& name) {
  return name.empty() ? "a name is missing: it is empty" : "";
}

void add_changes(CLI::App& app, Overrides& overrides) {
  app.add_option("--robots", overrides.robots, "Number of robots");
  app.add_option("--items", overrides.items, "Deliveries that end the run; 0: only the time limit ends it");
  app.add_option("--max-time", overrides.max_time_s, "Simulated seconds after which the run ends");
  app.add_option("--controller", overrides.controller,
                 "What drives the robots: paper, a shared library or a Python file; see " +
                     runtime::page("your_own_agent.md"));
  app.add_option("--pacing", overrides.pacing, "fast, realtime or free")
      ->check(CLI::IsMember({"fast", "realtime", "free"}));
}

void add_set(CLI::App& app, std::vector<std::string>& sets,
             const std::string& meaning =
                 "Another value for a key of the scenario, such as radio.range_m=4; repeatable") {
  app.add_option("--set", sets, meaning)->allow_extra_args(false)->type_name("KEY=VALUE");
}

void add_engine(CLI::App& app, std::string& engine) {
  app.add_option("--engine", engine, "dds: separate processes; embedded: all in one process")
      ->check(CLI::IsMember({"dds", "embedded"}))
      ->capture_default_str();
}

void add_transport(CLI::App& app, runtime::Transport& transport) {
  app.add_option_function<std::string>(
         "--transport", [&](const std::string& text) { transport = runtime::transport_named(text); },
         "DDS transport. shm: shared memory; udp: unicast on 127.0.0.1; FILE.xml: a profile, see " +
             runtime::page("hosts.md"))
      ->check(runtime::complaint_about_transport)
      ->default_str(to_text(transport));
}

void add_run_options(CLI::App& run, RunCommand& command, std::string& engine) {
  run.add_option("scenario", command.scenario, "Scenario file (TOML)")
      ->required()
      ->check(complaint_about_name);
  add_engine(run, engine);
  run.add_option("--mode", command.overrides.mode, "Communication: none, partial or full")
      ->check(CLI::IsMember({"none", "partial", "full"}));
  run.add_option("--seed", command.overrides.seed, "Seed of all random numbers")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{std::numeric_limits<std::int64_t>::max()}));
  add_changes(run, command.overrides);
  add_set(run, command.sets);
  run.add_option("--domain", command.domain, "DDS domain; default: a free one")->check(CLI::Range(0U, 232U));
  add_transport(run, command.transport);
  run.add_option("--agent", command.agent,
                 "Of the dds engine: any program that speaks the robot topics, in the place of robot_agent")
      ->check(CLI::ExistingFile);
  run.add_option("--agents-per-process", command.agents_per_process,
                 "For the dds engine: number of robots that share a process; faster with many robots")
      ->check(CLI::Range(1U, 65535U))
      ->capture_default_str();
  run.add_option("--out", command.out, "Folder for the results; must be new or empty")
      ->check(complaint_about_name);
  run.add_flag("--trace", command.trace, "Record every step, for `caravan diff` and `caravan step-agent`");
  run.add_flag("--quiet", command.quiet, "No progress, no result table");
  run.add_flag("--report", command.report, "Draw the report of the run when it has ended");
}

void add_rerun_options(CLI::App& rerun, RerunCommand& command) {
  rerun.add_option("run", command.run, "Folder of a run")->required()->check(complaint_about_name);
  rerun.add_option("--engine", command.engine, "dds or embedded; default: that of the run")
      ->check(CLI::IsMember({"dds", "embedded"}));
  rerun
      .add_option("--out", command.out,
                  "Folder for the results; must be new or empty; default: a new one in the run's folder")
      ->check(complaint_about_name);
  rerun.add_flag("--quiet", command.quiet, "No progress, no result table");
}

void add_report_options(CLI::App& report, ReportCommand& command) {
  report
      .add_option("folders", command.folders,
                  "Folders of runs, or folders that contain runs, such as those of sweeps")
      ->required()
      ->check(complaint_about_name);
  report.add_option("--out", command.out, "Target folder; default: report/ in the first folder")
      ->check(complaint_about_name);
}

void add_sweep_options(CLI::App& sweep, SweepCommand& command) {
  sweep.add_option("scenario", command.scenario, "Scenario file (TOML)")
      ->required()
      ->check(complaint_about_name);
  sweep.add_option("--seeds", command.seeds, "Seeds, as in 1-30 or 1,4,7-9")->capture_default_str();
  sweep.add_option(
      "--modes", command.modes,
      "Modes of communication, comma-separated; default: none,partial,full; with --set, --plan or a "
      "controller other than paper the scenario's");
  add_engine(sweep, command.engine);
  add_changes(sweep, command.overrides);
  add_set(sweep, command.sets,
          "Values for a key of the scenario, such as radio.range_m=2,4; repeatable, and then every "
          "combination is run; see " +
              runtime::page("sweeps.md"));
  sweep.add_option("--plan", command.plan, "File of a larger plan (TOML); see " + runtime::page("sweeps.md"))
      ->check(complaint_about_name);
  command.jobs = std::max(1U, std::thread::hardware_concurrency());
  sweep.add_option("--jobs", command.jobs, "Number of parallel runs; default: one per processor")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4096}));
  CLI::Option* out =
      sweep
          .add_option("--out", command.out, "Folder for the results; continues one that holds a part of them")
          ->check(complaint_about_name);
  CLI::Option* task = sweep.add_option(
      "--task-index", command.task,
      "Execute only the run with this index, from 0, and write no tables: for arrays of batch jobs");
  CLI::Option* summarise =
      sweep.add_flag("--summarise", command.summarise, "Only write the tables of existing runs")
          ->excludes(task);
  sweep.add_flag("--retry-failed", command.retry_failed, "Repeat failed runs")->excludes(summarise);
  CLI::Option* count =
      sweep.add_flag("--count", command.count, "Only print the number of runs")->excludes(task, summarise);
  sweep.add_flag("--quiet", command.quiet, "No progress, no table");
  sweep.callback([out, count] {
    if (out->empty() && count->empty()) throw CLI::RequiredError{"--out"};
  });
}

void add_step_agent_options(CLI::App& step_agent, StepAgentCommand& command) {
  step_agent.add_option("run", command.run, "Folder of a run with --trace")
      ->required()
      ->check(complaint_about_name);
  step_agent.add_option("--robot", command.robot, "Number of the robot, from 1")->required();
  step_agent
      .add_option("--controller", command.controller,
                  "What answers in its place: paper, a shared library or a Python file; default: what the "
                  "scenario says")
      ->check(complaint_about_name);
  step_agent
      .add_option("--scenario", command.scenario,
                  "Scenario with other parameters; default: that of the run, scenario.toml in its folder")
      ->check(complaint_about_name);
  step_agent
      .add_option("--step", command.step,
                  "Show one step whole, from 1: what the robot was given, and both answers")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{std::numeric_limits<std::int64_t>::max()}));
}

void add_deploy_options(CLI::App& deploy, DeployCommand& command) {
  deploy.add_option("script", command.script, "Script file (TOML)")->required()->check(complaint_about_name);
  deploy.add_option("--out", command.out, "Folder for the logs; must be new or empty")
      ->check(complaint_about_name);
  deploy.add_option("--junit", command.junit, "Report in JUnit XML; default: junit.xml in the log folder")
      ->check(complaint_about_name);
  deploy
      .add_option("--controller", command.controller,
                  "What drives the robots: paper, a shared library or a Python file")
      ->check(complaint_about_name);
  add_set(deploy, command.sets);
  deploy.add_option("--domain", command.domain, "DDS domain; default: a free one")
      ->check(CLI::Range(0U, 232U));
  add_transport(deploy, command.transport);
  deploy.add_flag("--check", command.check_only, "Check the script and start nothing");
  deploy.add_flag("--quiet", command.quiet, "Print failures only");
  deploy.footer(script_help());
}

void add_doctor_options(CLI::App& doctor, DoctorCommand& command) {
  doctor.add_option("--robots", command.robots, "Number of robots to run here")
      ->check(CLI::Range(1U, 65535U))
      ->capture_default_str();
  doctor.add_option("--domain", command.domain, "DDS domain to be used")
      ->check(CLI::Range(0U, 232U))
      ->capture_default_str();
  add_transport(doctor, command.transport);
  doctor.add_flag("--clean", command.clean, "Remove what dead processes have left in /dev/shm");
}

Exit explain(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return {app.exit(error)};
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "caravan" : "caravan " + chosen.front()->get_name();
  std::string why = error.what();
  if (const auto rest = app.remaining(); chosen.empty() && !rest.empty()) {
    const char* kind = rest.front().starts_with('-') ? "option" : "command";
    why = "there is no " + std::string{kind} + " \"" + rest.front() + "\"";
  }
  std::fprintf(stderr, "%s: %s (see %s --help)\n", command.c_str(), pure::one_line(why).c_str(),
               command.c_str());
  return {runtime::kCouldNotStart};
}

}  // namespace

Command read_command_line(int argc, const char* const* argv) {
  CLI::App app{"Runs swarms of transporting robots: agents, emulated world, emulated radio", "caravan"};
  app.set_version_flag("--version", "caravan " + std::string{runtime::kVersion});
  app.require_subcommand(1);
  RunCommand run_command;
  std::string engine = "dds";
  CLI::App* run = app.add_subcommand("run", "Run a scenario and report its result");
  add_run_options(*run, run_command, engine);
  RerunCommand rerun_command;
  CLI::App* rerun =
      app.add_subcommand("rerun", "Repeat a run from its folder; say whether it came out equal");
  add_rerun_options(*rerun, rerun_command);
  DiffCommand diff_command;
  CLI::App* diff = app.add_subcommand("diff", "Name the first difference between two runs with --trace");
  diff->add_option("one", diff_command.one, "Folder of a run")->required()->check(complaint_about_name);
  diff->add_option("other", diff_command.other, "Folder of another run")
      ->required()
      ->check(complaint_about_name);
  StepAgentCommand step_agent_command;
  CLI::App* step_agent = app.add_subcommand(
      "step-agent",
      "Give a controller what a robot was given in a run; name the first step it answers otherwise");
  add_step_agent_options(*step_agent, step_agent_command);
  SweepCommand sweep_command;
  CLI::App* sweep = app.add_subcommand("sweep", "Run a scenario with many seeds and modes");
  add_sweep_options(*sweep, sweep_command);
  CheckCommand check_command;
  CLI::App* check = app.add_subcommand("check", "Check a scenario file and run nothing");
  check->add_option("scenario", check_command.scenario, "Scenario file (TOML)")
      ->required()
      ->check(complaint_about_name);
  add_set(*check, check_command.sets);
  NewCommand new_command;
  CLI::App* new_project =
      app.add_subcommand("new", "Write a project of your own: controller, scenario, test; see " +
                                    runtime::page("your_own_agent.md"));
  new_project->add_option("name", new_command.name, "Name of the project and its folder: lower_snake_case")
      ->required();
  ReportCommand report_command;
  CLI::App* report = app.add_subcommand("report", "Draw the figures of recorded runs: one page, SVG and PNG");
  add_report_options(*report, report_command);
  CtlCommand ctl_command;
  CLI::App* ctl = app.add_subcommand("ctl", "Pause, step, steer or disturb a running run");
  ctl->add_option("--domain", ctl_command.domain, "DDS domain of the run")
      ->check(CLI::Range(0U, 232U))
      ->required();
  add_transport(*ctl, ctl_command.transport);
  ctl->add_option("words", ctl_command.words, "The request")->required();
  ctl->footer(ctl_help());
  DeployCommand deploy_command;
  CLI::App* deploy = app.add_subcommand("deploy", "Run a scripted test of a deployment");
  add_deploy_options(*deploy, deploy_command);
  DoctorCommand doctor_command;
  CLI::App* doctor =
      app.add_subcommand("doctor", "Check whether this host is ready for a run; says what to do if not");
  add_doctor_options(*doctor, doctor_command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explain(app, error);
  }
  run_command.embedded = engine == "embedded";
  run_command.command_line.assign(argv, argv + argc);
  rerun_command.command_line = run_command.command_line;
  if (check->parsed()) return check_command;
  if (new_project->parsed()) return new_command;
  if (rerun->parsed()) return rerun_command;
  if (diff->parsed()) return diff_command;
  if (step_agent->parsed()) return step_agent_command;
  if (sweep->parsed()) return sweep_command;
  if (report->parsed()) return report_command;
  if (ctl->parsed()) return ctl_command;
  if (deploy->parsed()) return deploy_command;
  if (doctor->parsed()) return doctor_command;
  return run_command;
}

}  // namespace caravan::deploy
