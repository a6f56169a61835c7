// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/command_line.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace caravan::deploy {
namespace {

using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

Command read(std::vector<const char*> words) {
  words.insert(words.begin(), "caravan");
  return read_command_line(static_cast<int>(words.size()), words.data());
}

/// The single line with which a wrong command line is refused.
std::string complaint(const std::vector<const char*>& words) {
  CaptureStderr();
  const auto command = read(words);
  std::string said = GetCapturedStderr();
  const Exit* exit = std::get_if<Exit>(&command);
  EXPECT_TRUE(exit != nullptr && exit->code == 2);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  return said;
}

TEST(CommandLine, ARunWithoutOptionsChangesNothingAndUsesDds) {
  const auto command = read({"run", "small.toml"});

  const auto& run = std::get<RunCommand>(command);
  EXPECT_EQ(run.scenario, "small.toml");
  EXPECT_FALSE(run.embedded);
  EXPECT_FALSE(run.quiet);
  EXPECT_FALSE(run.report);
  EXPECT_FALSE(run.trace);
  EXPECT_EQ(run.overrides.mode, std::nullopt);
  EXPECT_EQ(run.overrides.seed, std::nullopt);
  EXPECT_EQ(run.domain, std::nullopt);
  EXPECT_EQ(run.out, std::nullopt);
  EXPECT_EQ(run.transport, runtime::Transport::kSharedMemory);
  EXPECT_EQ(run.agents_per_process, 1U);
}

TEST(CommandLine, ARunKeepsItsWordsForTheRecord) {
  const auto command = read({"run", "small.toml", "--seed", "2"});

  EXPECT_THAT(std::get<RunCommand>(command).command_line,
              testing::ElementsAre("caravan", "run", "small.toml", "--seed", "2"));
}

TEST(CommandLine, ARerunTakesTheFolderOfARun) {
  const auto plain = read({"rerun", "runs/a"});
  const auto full = read({"rerun", "runs/a", "--engine", "embedded", "--out", "/tmp/x", "--quiet"});

  EXPECT_EQ(std::get<RerunCommand>(plain).run, "runs/a");
  EXPECT_EQ(std::get<RerunCommand>(plain).engine, std::nullopt);
  EXPECT_EQ(std::get<RerunCommand>(plain).out, std::nullopt);
  EXPECT_FALSE(std::get<RerunCommand>(plain).quiet);
  EXPECT_EQ(std::get<RerunCommand>(full).engine, "embedded");
  EXPECT_EQ(std::get<RerunCommand>(full).out, "/tmp/x");
  EXPECT_TRUE(std::get<RerunCommand>(full).quiet);
  EXPECT_EQ(std::get<RerunCommand>(full).command_line.size(), 8U);
  EXPECT_THAT(complaint({"rerun"}), testing::HasSubstr("run"));
  EXPECT_THAT(complaint({"rerun", "a", "--engine", "gazebo"}), testing::HasSubstr("gazebo"));
}

TEST(CommandLine, ANewProjectHasOneName) {
  EXPECT_EQ(std::get<NewCommand>(read({"new", "my_swarm"})).name, "my_swarm");
  EXPECT_THAT(complaint({"new"}), testing::HasSubstr("name"));
  EXPECT_THAT(complaint({"new", "a", "b"}), testing::HasSubstr("b"));
}

TEST(CommandLine, NamesPagesThatAreThereInItsHelp) {
  for (const char* command : {"run", "sweep", "ctl", "deploy", "doctor"}) {
    CaptureStdout();
    (void)read({command, "--help"});
    const std::string help = GetCapturedStdout();
    const std::regex page{"/\\S+\\.md"};
    const std::sregex_iterator first{help.begin(), help.end(), page};
    EXPECT_NE(first, std::sregex_iterator{}) << command;
    for (auto found = first; found != std::sregex_iterator{}; ++found)
      EXPECT_TRUE(std::filesystem::is_regular_file(found->str())) << found->str();
  }
}

TEST(CommandLine, NamesAnUnknownCommandAndTheHelpOfTheCommandThatIsWrong) {
  EXPECT_EQ(complaint({"bogus"}), "caravan: there is no command \"bogus\" (see caravan --help)\n");
  EXPECT_EQ(complaint({"bogus", "small.toml", "--quiet"}),
            "caravan: there is no command \"bogus\" (see caravan --help)\n");
  EXPECT_EQ(complaint({"--bogus"}), "caravan: there is no option \"--bogus\" (see caravan --help)\n");
  EXPECT_THAT(complaint({}), testing::EndsWith("(see caravan --help)\n"));
  for (const char* command : {"run", "sweep", "step-agent", "ctl", "deploy", "doctor", "check"}) {
    const std::string said = complaint({command, "--bogus"});
    EXPECT_THAT(said, testing::StartsWith("caravan " + std::string{command} + ": "));
    EXPECT_THAT(said, testing::EndsWith("(see caravan " + std::string{command} + " --help)\n"));
  }
}

TEST(CommandLine, AReportTakesAnyNumberOfFoldersAndAtLeastOne) {
  const auto command = read({"report", "runs/a", "runs/b", "--out", "/tmp/x"});

  const auto& report = std::get<ReportCommand>(command);
  EXPECT_THAT(report.folders, testing::ElementsAre("runs/a", "runs/b"));
  EXPECT_EQ(report.out, "/tmp/x");
  EXPECT_THAT(complaint({"report"}), testing::HasSubstr("folders"));
}

TEST(CommandLine, RefusesNamesOfFilesAndFoldersThatAreEmpty) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{"run", ""},
                                             {"run", "a.toml", "--out", ""},
                                             {"sweep", "a.toml", "--out", ""},
                                             {"check", ""},
                                             {"report", ""},
                                             {"report", "a", "--out", ""},
                                             {"rerun", ""},
                                             {"rerun", "a", "--out", ""},
                                             {"diff", "a", ""},
                                             {"step-agent", "", "--robot", "1"},
                                             {"deploy", ""},
                                             {"deploy", "a.toml", "--out", ""},
                                             {"deploy", "a.toml", "--junit", ""}})
    EXPECT_THAT(complaint(words), testing::HasSubstr("a name is missing: it is empty"));
}

TEST(CommandLine, TakesEveryOptionOfARun) {
  const auto command =
      read({"run",        "paper.toml", "--engine", "embedded",    "--mode",   "partial",
            "--seed",     "9",          "--robots", "5",           "--items",  "0",
            "--max-time", "90.5",       "--pacing", "realtime",    "--domain", "12",
            "--out",      "/tmp/x",     "--quiet",  "--transport", "udp",      "--agents-per-process",
            "8",          "--report",   "--trace"});

  const auto& run = std::get<RunCommand>(command);
  EXPECT_TRUE(run.embedded);
  EXPECT_EQ(run.overrides.mode, "partial");
  EXPECT_EQ(run.overrides.seed, 9U);
  EXPECT_EQ(run.overrides.robots, 5U);
  EXPECT_EQ(run.overrides.items, 0U);
  EXPECT_EQ(run.overrides.max_time_s, 90.5);
  EXPECT_EQ(run.overrides.pacing, "realtime");
  EXPECT_EQ(run.domain, 12U);
  EXPECT_EQ(run.out, "/tmp/x");
  EXPECT_EQ(run.transport, runtime::Transport::kUdp);
  EXPECT_EQ(run.agents_per_process, 8U);
  EXPECT_TRUE(run.quiet);
  EXPECT_TRUE(run.report);
  EXPECT_TRUE(run.trace);
}

TEST(CommandLine, TakesAnyNumberOfSettingsOneAtATime) {
  using testing::ElementsAre;
  const auto run = read({"run", "--set", "radio.range_m=[1,2]", "--set", "a.b=x", "small.toml"});
  EXPECT_THAT(std::get<RunCommand>(run).sets, ElementsAre("radio.range_m=[1,2]", "a.b=x"));
  EXPECT_EQ(std::get<RunCommand>(run).scenario, "small.toml");
  EXPECT_THAT(std::get<CheckCommand>(read({"check", "a.toml", "--set", "a.b=1"})).sets, ElementsAre("a.b=1"));
  EXPECT_THAT(std::get<DeployCommand>(read({"deploy", "a.toml", "--set=a.b=1"})).sets, ElementsAre("a.b=1"));
  const auto sweep = read({"sweep", "a.toml", "--set", "a.b=1,2", "--plan", "plan.toml", "--out", "x"});
  EXPECT_THAT(std::get<SweepCommand>(sweep).sets, ElementsAre("a.b=1,2"));
  EXPECT_EQ(std::get<SweepCommand>(sweep).plan, "plan.toml");
  EXPECT_EQ(std::get<SweepCommand>(sweep).modes, std::nullopt);
  EXPECT_THAT(complaint({"run", "a.toml", "--set"}), testing::HasSubstr("--set"));
}

TEST(CommandLine, TakesEveryOptionOfASweep) {
  const auto command =
      read({"sweep",   "a.toml", "--seeds",      "1-30", "--modes",        "none,full", "--jobs",   "3",
            "--items", "5",      "--robots",     "4",    "--max-time",     "60",        "--pacing", "fast",
            "--out",   "/tmp/x", "--task-index", "7",    "--retry-failed", "--quiet",   "--engine", "dds"});

  const auto& sweep = std::get<SweepCommand>(command);
  EXPECT_EQ(sweep.seeds, "1-30");
  EXPECT_EQ(sweep.modes, "none,full");
  EXPECT_EQ(sweep.engine, "dds");
  EXPECT_EQ(sweep.jobs, 3U);
  EXPECT_EQ(sweep.overrides.items, 5U);
  EXPECT_EQ(sweep.overrides.robots, 4U);
  EXPECT_EQ(sweep.overrides.max_time_s, 60.0);
  EXPECT_EQ(sweep.overrides.pacing, "fast");
  EXPECT_EQ(sweep.out, "/tmp/x");
  EXPECT_EQ(sweep.task, 7U);
  EXPECT_TRUE(sweep.retry_failed);
  EXPECT_TRUE(sweep.quiet);
}

TEST(CommandLine, ASweepIsEmbeddedAndSharesTheProcessorsUnlessToldOtherwise) {
  const auto command = read({"sweep", "a.toml", "--out", "/tmp/x"});

  const auto& sweep = std::get<SweepCommand>(command);
  EXPECT_EQ(sweep.engine, "embedded");
  EXPECT_GE(sweep.jobs, 1U);
  EXPECT_EQ(sweep.task, std::nullopt);
  EXPECT_FALSE(sweep.summarise);
}

TEST(CommandLine, ComparesTwoRuns) {
  const auto command = read({"diff", "runs/a", "runs/b"});
  EXPECT_EQ(std::get<DiffCommand>(command).one, "runs/a");
  EXPECT_EQ(std::get<DiffCommand>(command).other, "runs/b");
}

TEST(CommandLine, StepsAnAgentOfARun) {
  const auto command =
      read({"step-agent", "runs/a", "--robot", "3", "--controller", "mine.so", "--scenario", "b.toml"});
  const auto& step_agent = std::get<StepAgentCommand>(command);
  EXPECT_EQ(step_agent.run, "runs/a");
  EXPECT_EQ(step_agent.robot, 3U);
  EXPECT_EQ(step_agent.controller, "mine.so");
  EXPECT_EQ(step_agent.scenario, "b.toml");
  EXPECT_EQ(std::get<StepAgentCommand>(read({"step-agent", "a", "--robot", "1"})).controller, std::nullopt);
}

TEST(CommandLine, DeploysAScriptOverSharedMemoryUnlessToldOtherwise) {
  EXPECT_EQ(std::get<DeployCommand>(read({"deploy", "a.toml"})).transport, runtime::Transport::kSharedMemory);
  EXPECT_EQ(std::get<DeployCommand>(read({"deploy", "a.toml", "--transport", "udp"})).transport,
            runtime::Transport::kUdp);
}

TEST(CommandLine, ChecksWithoutRunning) {
  const auto command = read({"check", "small.toml"});
  EXPECT_EQ(std::get<CheckCommand>(command).scenario, "small.toml");
}

TEST(CommandLine, AnswersMistakesWithOneLineThatNamesThem) {
  EXPECT_THAT(complaint({}), testing::HasSubstr("subcommand"));
  EXPECT_THAT(complaint({"run"}), testing::HasSubstr("scenario"));
  EXPECT_THAT(complaint({"run", "a.toml", "--mode", "loud"}), testing::HasSubstr("--mode"));
  EXPECT_THAT(complaint({"run", "a.toml", "--engine", "magic"}), testing::HasSubstr("--engine"));
  EXPECT_THAT(complaint({"run", "a.toml", "--seed", "-1"}), testing::HasSubstr("--seed"));
  EXPECT_THAT(complaint({"run", "a.toml", "--robots", "many"}), testing::HasSubstr("--robots"));
  EXPECT_THAT(complaint({"run", "a.toml", "--domain", "233"}), testing::HasSubstr("--domain"));
  EXPECT_THAT(complaint({"diff", "runs/a"}), testing::HasSubstr("other"));
  EXPECT_THAT(complaint({"step-agent", "runs/a"}), testing::HasSubstr("--robot"));
  EXPECT_THAT(complaint({"sweep", "a.toml"}), testing::HasSubstr("--out"));
  EXPECT_THAT(complaint({"sweep", "a.toml", "--out", "o", "--jobs", "0"}), testing::HasSubstr("--jobs"));
  EXPECT_THAT(complaint({"sweep", "a.toml", "--out", "o", "--summarise", "--task-index", "1"}),
              testing::HasSubstr("--summarise"));
  EXPECT_THAT(complaint({"run", "a.toml", "--transport", "carrier-pigeon"}),
              testing::HasSubstr("--transport"));
  EXPECT_THAT(complaint({"run", "a.toml", "--agents-per-process", "0"}),
              testing::HasSubstr("--agents-per-process"));
  EXPECT_THAT(complaint({"run", "a.toml", "--colour", "red"}), testing::HasSubstr("--colour"));
}

TEST(CommandLine, ShowsTheVersionAndEndsWell) {
  CaptureStdout();
  const auto command = read({"--version"});

  EXPECT_THAT(GetCapturedStdout(), testing::MatchesRegex("caravan [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_EQ(std::get<Exit>(command).code, 0);
}

}  // namespace
}  // namespace caravan::deploy
