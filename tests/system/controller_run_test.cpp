// SPDX-License-Identifier: Apache-2.0
// Controllers from shared libraries, in both engines.
#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "build_paths.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::Process;
using test::read_file;
using testing::ContainsRegex;
using testing::HasSubstr;

const fs::path kLibraries = fs::path{CARAVAN_BIN_DIR}.parent_path() / "tests/controllers";
const fs::path kPython = fs::path{CARAVAN_SOURCE_DIR} / "tests/controllers/python";
const std::string kHangs = "hangs";  // a fault of the controller `faulty`

class ControllerRun : public testing::Test {
 protected:
  struct Ended {
    std::optional<int> exit_code;
    std::string said;
    nlohmann::json metrics;
  };
  /// Runs the small scenario with `keys` in its table [controller].
  Ended run(const std::string& keys, const std::string& engine, const std::string& name,
            const std::vector<std::string>& more) {
    const fs::path file = folder_ / "mine.toml";
    test::write_file(file, read_file(test::scenario("small.toml")) + "\n[controller]\n" + keys);
    std::vector<std::string> words = {"caravan", "run", file,      "--engine", engine,
                                      "--items", "0",   "--quiet", "--out",    folder_ / name};
    if (std::ranges::find(more, "--max-time") == more.end()) words.insert(words.end(), {"--max-time", "20"});
    words.insert(words.end(), more.begin(), more.end());
    Process process{words, folder_ / (name + ".log")};
    Ended ended{process.wait(test::kPatience), process.output(), {}};
    if (fs::exists(folder_ / name / "metrics.json"))
      ended.metrics = nlohmann::json::parse(read_file(folder_ / name / "metrics.json"));
    return ended;
  }
  [[nodiscard]] std::string log_of(const std::string& run, const std::string& process) const {
    return read_file(folder_ / run / "logs" / (process + ".log"));
  }

  test::ScratchFolder folder_;
};

TEST_F(ControllerRun, GivesTheSameDigestInBothEnginesAndEveryPlacement) {
  const std::vector<std::string> chatterer = {"--controller", kLibraries / "chatterer.so"};
  const Ended embedded = run("cruise_mps = 0.5\n", "embedded", "embedded", chatterer);
  ASSERT_EQ(embedded.exit_code, 0) << embedded.said;
  EXPECT_EQ(embedded.metrics["controller"], "chatterer");
  const Ended dds = run("cruise_mps = 0.5\n", "dds", "dds", chatterer);
  ASSERT_EQ(dds.exit_code, 0) << dds.said;
  EXPECT_EQ(dds.metrics["digest"], embedded.metrics["digest"]);
  std::vector<std::string> together = chatterer;
  together.insert(together.end(), {"--agents-per-process", "4"});
  EXPECT_EQ(run("cruise_mps = 0.5\n", "dds", "together", together).metrics["digest"],
            embedded.metrics["digest"]);
  EXPECT_NE(run("cruise_mps = 0.4\n", "embedded", "slower", chatterer).metrics["digest"],
            embedded.metrics["digest"]);
  EXPECT_THAT(read_file(folder_ / "dds" / "events.csv"), HasSubstr(",began,turn="));
}

TEST_F(ControllerRun, TakesTheLibraryThatTheScenarioNamesFromTheScenariosFolder) {
  fs::copy_file(kLibraries / "chatterer.so", folder_ / "here.so");
  const Ended ended = run("library = \"here.so\"\n", "dds", "out", {});
  EXPECT_EQ(ended.exit_code, 0) << ended.said;
  EXPECT_EQ(ended.metrics["controller"], "chatterer");
}

TEST_F(ControllerRun, RefusesABadLibraryBeforeAnythingStarts) {
  for (const char* engine : {"dds", "embedded"}) {
    const Ended ended = run("", engine, engine, {"--controller", kLibraries / "no_entry.so"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.said, HasSubstr("add CARAVAN_CONTROLLER"));
    EXPECT_FALSE(fs::exists(folder_ / engine));
  }
}

TEST_F(ControllerRun, RefusesAConstructorThatFailsForAnyRobotBeforeAnythingStarts) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"constructor", "controller faulty, robot 2: cannot be made: no map"},
      {"constructor_hangs", "controller faulty, robot 2: its constructor has not returned for 10 s"},
      {"constructor_aborts",
       "controller faulty, robot 2: its constructor ended the process that made it, by signal 6 (Aborted)"},
      {"constructor_exits",
       "controller faulty, robot 2: its constructor ended the process that made it, by exit code 0"},
      {"destructor_hangs", "controller faulty, robot 2: its destructor has not returned for 10 s"},
      {"destructor_aborts",
       "controller faulty, robot 2: its destructor ended the process that made it, by signal 6 (Aborted)"}};
  for (const auto& [fault, said] : faults) {
    const Ended ended =
        run("fault = \"" + fault + "\"\n", "embedded", fault, {"--controller", kLibraries / "faulty.so"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.said, HasSubstr(said));
    EXPECT_FALSE(fs::exists(folder_ / fault));
  }
}

TEST_F(ControllerRun, RefusesAReportBeyondItsLimitsInBothEngines) {
  for (const std::string fault : {"report_far", "report_activity"}) {
    const std::string keys = "at_step = 40\nfault = \"" + fault + "\"\n";
    const std::vector<std::string> faulty = {"--controller", kLibraries / "faulty.so"};
    const Ended embedded = run(keys, "embedded", fault, faulty);
    EXPECT_EQ(embedded.exit_code, 1);
    EXPECT_THAT(embedded.said, HasSubstr("controller faulty, robot 2, step 40 (1.248 s): report."));
    const Ended dds = run(keys, "dds", fault + "_dds", faulty);
    EXPECT_EQ(dds.metrics["sim_time_s"], 20.0) << "the run continues without it";
    EXPECT_THAT(log_of(fault + "_dds", "robot_agent_2"), HasSubstr("robot 2, step 40 (1.248 s): report."));
  }
}

TEST_F(ControllerRun, ItsRoundingDoesNotReachTheWorld) {
  const std::vector<std::string> rounds_up = {"--controller", kLibraries / "rounds_up.so"};
  const Ended nearest = run("in_steps = false\nin_constructor = false\n", "dds", "nearest", rounds_up);
  ASSERT_EQ(nearest.exit_code, 0) << nearest.said;
  EXPECT_EQ(run("", "embedded", "up", rounds_up).metrics["digest"], nearest.metrics["digest"]);
}

/// Four robots: together they take longer than one may.
TEST_F(ControllerRun, GivesEachConstructorItsTime) {
  const fs::path file = folder_ / "mine.toml";
  test::write_file(file, read_file(test::scenario("small.toml")) +
                             "\n[controller]\nfault = \"constructors_are_slow\"\nlibrary = \"" +
                             (kLibraries / "faulty.so").string() + "\"\n");
  Process process{{"caravan", "check", file}, folder_ / "log"};
  EXPECT_EQ(process.wait(test::kPatience), 0) << process.output();
}

TEST_F(ControllerRun, DoesNotTakeAnExitOfTheControllerForItsOwn) {
  const Ended ended =
      run("at_step = 40\nfault = \"exits\"\n", "embedded", "out", {"--controller", kLibraries / "faulty.so"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.said, HasSubstr("controller faulty, robot 2, step 40 (1.248 s): has called exit()"));
}

TEST_F(ControllerRun, NamesAControllerThatCrashes) {
  for (const char* fault : {"crashes", "overflows"}) {
    const Ended ended = run("at_step = 600\nfault = \"" + std::string{fault} + "\"\n", "embedded", fault,
                            {"--controller", kLibraries / "faulty.so"});
    EXPECT_EQ(ended.exit_code, 128 + SIGSEGV);
    EXPECT_THAT(ended.said,
                HasSubstr("controller faulty, robot 2, step 600 (19.168 s): ends the process by SIGSEGV"));
  }
}

/// An agent steps on a thread of DDS; several in a process step on another one of their own.
TEST_F(ControllerRun, NamesAControllerThatCrashesOnAThreadOfDds) {
  const std::vector<std::vector<std::string>> runs = {{"crashes", "1", "robot_agent_2"},
                                                      {"overflows", "1", "robot_agent_2"},
                                                      {"overflows", "2", "robot_agent_1-2"}};
  for (const auto& one : runs) {
    const std::string name = one[0] + one[1];
    const Ended dds = run("at_step = 40\nfault = \"" + one[0] + "\"\n", "dds", name,
                          {"--controller", kLibraries / "faulty.so", "--agents-per-process", one[1]});
    EXPECT_EQ(dds.exit_code, 0) << dds.said;
    EXPECT_THAT(log_of(name, one[2]),
                HasSubstr("controller faulty, robot 2, step 40 (1.248 s): ends the process by SIGSEGV"));
  }
}

TEST_F(ControllerRun, IsInterruptedAtOnceWhileAStepDoesNotReturn) {
  const fs::path file = folder_ / "mine.toml";
  test::write_file(
      file, read_file(test::scenario("small.toml")) + "\n[controller]\nfault = \"hangs\"\nat_step = 40\n");
  Process process{{"caravan", "run", file, "--engine", "embedded", "--items", "0", "--quiet", "--out",
                   folder_ / "out", "--controller", kLibraries / "faulty.so"},
                  folder_ / "log"};
  ASSERT_TRUE(process.prints("faulty hangs", test::kPatience)) << process.output();
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(test::kPatience), 130) << process.output();
  EXPECT_THAT(
      process.output(),
      HasSubstr(
          "controller faulty, robot 2, step 40 (1.248 s): has not returned, and this process is stopped"));
  const auto metrics = nlohmann::json::parse(read_file(folder_ / "out/metrics.json"));
  EXPECT_EQ(metrics["ended"], true);
}

TEST_F(ControllerRun, IsInterruptedAtOnceWhileAConstructorDoesNotReturn) {
  const fs::path file = folder_ / "mine.toml";
  test::write_file(file, read_file(test::scenario("small.toml")) +
                             "\n[controller]\nfault = \"constructor_hangs\"\nlibrary = \"" +
                             (kLibraries / "faulty.so").string() + "\"\n");
  // `check` and `step-agent` leave the signal to the system, `run` and `sweep` do not.
  for (const std::string command : {"run", "sweep", "check"}) {
    std::vector<std::string> words{"caravan", command, file};
    if (command != "check") words.insert(words.end(), {"--out", folder_ / "out"});
    Process process{words, folder_ / (command + ".log")};
    ASSERT_TRUE(process.prints("faulty hangs", test::kPatience)) << process.output();
    process.signal(SIGINT);
    EXPECT_EQ(process.wait(test::kPatience), 130) << process.output();
    const char* said = command == "check" ? "" : "stopped while it tried the controllers";
    EXPECT_THAT(process.output(), HasSubstr(said));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(ControllerRun, EndsAnEmbeddedRunThatAControllerBreaksAndClosesItsRecords) {
  for (const std::string& fault : {std::string{"throws"}, std::string{"nan"}, kHangs}) {
    const Ended ended = run("at_step = 40\nfault = \"" + fault + "\"\n", "embedded", fault,
                            {"--controller", kLibraries / "faulty.so"});
    EXPECT_EQ(ended.exit_code, 1) << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("controller faulty, robot 2, step 40 (1.248 s): "));
    EXPECT_THAT(ended.said, HasSubstr(fault == kHangs ? ": has not returned for 10 s\n" : ""));
    EXPECT_EQ(ended.metrics["ended"], true);
    EXPECT_EQ(ended.metrics["completed"], false);
  }
}

TEST_F(ControllerRun, GoesOnOverDdsWithoutTheRobotWhoseControllerFailed) {
  for (const std::string& fault : {std::string{"throws"}, std::string{"nan"}, std::string{"exits"}, kHangs}) {
    const Ended ended = run("at_step = 40\nfault = \"" + fault + "\"\n", "dds", fault,
                            {"--controller", kLibraries / "faulty.so"});
    EXPECT_EQ(ended.exit_code, 0) << ended.said;
    EXPECT_EQ(ended.metrics["disturbed"], true);
    EXPECT_THAT(log_of(fault, "robot_agent_2"), HasSubstr("controller faulty, robot 2"));
    EXPECT_THAT(log_of(fault, "robot_agent_2"),
                HasSubstr(fault == kHangs ? "step 40 (1.248 s): has not returned for 10 s\n" : ""));
    EXPECT_EQ(ended.metrics["sim_time_s"], 20.0);
    EXPECT_THAT(ended.said,
                ContainsRegex("robot_agent_2 \\(pid [0-9]+\\) ended with exit code 1, its log says "
                              "why: controller faulty, robot 2, step 40 \\(1\\.248 s\\): "));
  }
}

TEST_F(ControllerRun, SaysOnceThatTheRadioDropsFramesInBothEngines) {
  const std::string keys =
      "fault = \"long_frame\"\nlibrary = \"" + (kLibraries / "faulty.so").string() + "\"\n";
  const std::string said =
      "controller faulty, robot 2, step 3 (0.064 s): the radio drops a frame of 5000 bytes";
  const Ended embedded = run(keys, "embedded", "embedded", {"--max-time", "2"});
  EXPECT_EQ(embedded.exit_code, 0);
  EXPECT_THAT(embedded.said, testing::StartsWith(said));
  EXPECT_EQ(std::count(embedded.said.begin(), embedded.said.end(), '\n'), 1) << embedded.said;
  EXPECT_EQ(embedded.metrics["frames"]["over_mtu"], 2);
  const Ended dds = run(keys, "dds", "dds", {"--max-time", "2"});
  EXPECT_EQ(dds.exit_code, 0);
  EXPECT_THAT(log_of("dds", "robot_agent_2"), HasSubstr(" warning robot_agent: " + said));
}

TEST_F(ControllerRun, IsDisturbedWhenTheOnlyProcessOfAllRobotsFails) {
  const Ended ended = run("at_step = 200\nfault = \"throws\"\n", "dds", "out",
                          {"--controller", kLibraries / "faulty.so", "--agents-per-process", "4"});
  EXPECT_EQ(ended.exit_code, 1) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("every agent has ended"));
  EXPECT_EQ(ended.metrics["disturbed"], true);
}

TEST_F(ControllerRun, NamesTheControllerThatFailedWhenTheRunEndsAtOnce) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"throws", "threw an exception: no such cell"},
      {"nan", "wheel speeds nan"},
      {"exits", "has called exit()"},
      {"crashes", "ends the process by SIGSEGV"}};
  for (const auto& [fault, said] : faults) {
    const Ended ended = run("at_step = 90\nfault = \"" + fault + "\"\nlibrary = \"" +
                                (kLibraries / "faulty.so").string() + "\"\n",
                            "dds", fault, {"--max-time", "3"});
    EXPECT_EQ(ended.exit_code, 0) << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("controller faulty, robot 2, step 90 (2.848 s): " + said));
    const std::string once = "controller faulty, robot 2";
    EXPECT_EQ(ended.said.find(once), ended.said.rfind(once)) << ended.said;
  }
}

class PythonControllerRun : public ControllerRun {
 protected:
  void SetUp() override {
    if (test::kIsSanitized) GTEST_SKIP() << "the sanitizers report Python's own memory";
  }
};

TEST_F(PythonControllerRun, GivesTheSameDigestInBothEnginesAndAsTheSameControllerInCpp) {
  const std::string keys = "cruise_mps = 0.5\n";
  const std::vector<std::string> python = {"--controller", kPython / "chatterer.py"};
  const Ended cpp = run(keys, "embedded", "cpp", {"--controller", kLibraries / "chatterer.so"});
  const Ended embedded = run(keys, "embedded", "embedded", python);
  ASSERT_EQ(embedded.exit_code, 0) << embedded.said;
  EXPECT_EQ(embedded.metrics["controller"], "chatterer");
  EXPECT_EQ(embedded.metrics["digest"], cpp.metrics["digest"]);
  const Ended dds = run(keys, "dds", "dds", python);
  ASSERT_EQ(dds.exit_code, 0) << dds.said;
  EXPECT_EQ(dds.metrics["digest"], embedded.metrics["digest"]);
  std::vector<std::string> together = python;
  together.insert(together.end(), {"--agents-per-process", "4"});
  EXPECT_EQ(run(keys, "dds", "together", together).metrics["digest"], embedded.metrics["digest"]);
  EXPECT_THAT(read_file(folder_ / "dds" / "events.csv"), HasSubstr(",began,turn="));
}

TEST_F(PythonControllerRun, UsesDebiansPackagesWhateverPythonComesFirstInThePath) {
  const fs::path other = folder_ / "other";
  for (const char* version : {"python3.11", "python3.13"}) {
    fs::create_directories(other / "lib" / version / "lib-dynload");
    test::write_file(other / "lib" / version / "os.py", "raise ImportError\n");
  }
  fs::create_directories(other / "bin");
  test::write_file(other / "bin/python3", "#!/bin/sh\n");
  fs::permissions(other / "bin/python3", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", ((other / "bin").string() + ":" + path).c_str(), 1);
  const Ended ended = run("", "embedded", "out", {"--controller", kPython / "chatterer.py"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.exit_code, 0) << ended.said;
}

TEST_F(PythonControllerRun, EndsARunThatItBreaksAndClosesItsRecords) {
  for (const char* fault : {"throws", "nan", "nothing", "hangs"}) {
    const Ended ended = run("at_step = 40\nfault = \"" + std::string{fault} + "\"\n", "embedded", fault,
                            {"--controller", kPython / "faulty.py"});
    EXPECT_EQ(ended.exit_code, 1) << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("controller faulty, robot 2, step 40"));
    EXPECT_EQ(ended.metrics["ended"], true);
  }
}

TEST_F(PythonControllerRun, GoesOnOverDdsWithoutTheRobotWhoseControllerFailed) {
  for (const char* fault : {"throws", "hangs"}) {
    const Ended ended = run("at_step = 40\nfault = \"" + std::string{fault} + "\"\n", "dds", fault,
                            {"--controller", kPython / "faulty.py"});
    EXPECT_EQ(ended.exit_code, 0) << ended.said;
    EXPECT_EQ(ended.metrics["disturbed"], true);
    EXPECT_THAT(log_of(fault, "robot_agent_2"), HasSubstr("controller faulty, robot 2"));
    EXPECT_EQ(ended.metrics["sim_time_s"], 20.0);
  }
}

TEST_F(PythonControllerRun, DeliversAllItemsByVirtualPheromone) {
  const fs::path pheromone = fs::path{CARAVAN_SOURCE_DIR} / "deploy/controllers/pheromone.py";
  Process process{{"caravan", "run", test::scenario("small.toml"), "--engine", "embedded", "--controller",
                   pheromone, "--quiet", "--out", folder_ / "out"},
                  folder_ / "out.log"};
  EXPECT_EQ(process.wait(test::kPatience), 0) << process.output();
  const auto metrics = nlohmann::json::parse(read_file(folder_ / "out" / "metrics.json"));
  EXPECT_EQ(metrics["completed"], true);
  EXPECT_EQ(metrics["items_delivered"], 4);
  const auto& robots = metrics["per_robot"];
  const auto has_heard = [](const auto& robot) { return !robot["received_s"].is_null(); };
  EXPECT_TRUE(std::any_of(robots.begin(), robots.end(), has_heard)) << "of the destination, by radio";
}

TEST_F(PythonControllerRun, RefusesAFileThatCannotBeImportedBeforeAnythingStarts) {
  const Ended ended = run("", "dds", "out", {"--controller", kPython / "missing_module.py"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.said, HasSubstr("missing_module.py:4: ModuleNotFoundError: No module named"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(ControllerRun, StartsAnotherProgramInThePlaceOfTheAgent) {
  const fs::path program = folder_ / "my_agent";
  test::write_file(program, "#!/bin/sh\necho \"my agent: $*\"\nexec " +
                                (fs::path{CARAVAN_BIN_DIR} / "robot_agent").string() + " \"$@\"\n");
  const Ended refused = run("", "dds", "refused", {"--agent", program});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.said, HasSubstr("is not executable"));
  fs::permissions(program, fs::perms::owner_all);
  const Ended ended = run("", "dds", "mine", {"--agent", program});
  ASSERT_EQ(ended.exit_code, 0) << ended.said;
  EXPECT_EQ(ended.metrics["controller"], "my_agent");
  EXPECT_EQ(ended.metrics["digest"], run("", "dds", "ours", {}).metrics["digest"]);
  EXPECT_THAT(log_of("mine", "robot_agent_3"), HasSubstr("my agent: --scenario "));
  EXPECT_EQ(run("", "embedded", "embedded", {"--agent", program}).exit_code, 2);
}

}  // namespace
}  // namespace caravan
