// SPDX-License-Identifier: Apache-2.0
// `caravan step-agent`: a controller is given what a robot was given in a run.
#include <gmock/gmock.h>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace fs = std::filesystem;
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

const fs::path kBuild = fs::path{CARAVAN_BIN_DIR}.parent_path();
const std::string kBraitenberg = kBuild / "controllers/braitenberg.so";
const std::string kChatterer = kBuild / "tests/controllers/chatterer.so";
const std::string kFaulty = kBuild / "tests/controllers/faulty.so";

class StepAgent : public testing::Test {
 protected:
  struct Ended {
    std::optional<int> exit_code;
    std::string said;
  };
  Ended caravan(std::vector<std::string> words) {
    words.insert(words.begin(), "caravan");
    Process process{words, folder_ / ("caravan" + std::to_string(++processes_) + ".log")};
    return {process.wait(kPatience), process.output()};
  }
  /// The small scenario with `keys` in its table [controller].
  fs::path scenario_with(const std::string& keys) {
    const fs::path file = folder_ / ("scenario" + std::to_string(++processes_) + ".toml");
    write_file(file, read_file(scenario("small.toml")) + "\n[controller]\n" + keys);
    return file;
  }
  /// A run of it. @return its folder
  fs::path run(const fs::path& scenario, std::vector<std::string> more, int code = 0) {
    const fs::path out = folder_ / ("run" + std::to_string(++processes_));
    more.insert(more.begin(), {"run", scenario, "--items", "0", "--quiet", "--out", out});
    const Ended ended = caravan(more);
    EXPECT_EQ(ended.exit_code, code) << ended.said;
    return out;
  }
  fs::path run_embedded(const fs::path& scenario, std::vector<std::string> more = {}, int code = 0) {
    more.insert(more.end(), {"--engine", "embedded", "--max-time", "10", "--trace"});
    return run(scenario, more, code);
  }
  Ended step_agent(const fs::path& run, const std::vector<std::string>& more = {},
                   const std::string& robot = "3") {
    std::vector<std::string> words{"step-agent", run, "--robot", robot};
    words.insert(words.end(), more.begin(), more.end());
    return caravan(words);
  }

  ScratchFolder folder_;
  int processes_ = 0;
};

TEST_F(StepAgent, FindsThatTheRunsOwnControllerAnswersTheSameInBothEngines) {
  const std::vector<std::string> options = {"--max-time", "70", "--trace"};
  std::vector<std::string> embedded_options = options;
  embedded_options.insert(embedded_options.end(), {"--engine", "embedded"});
  std::vector<std::string> together_options = options;
  together_options.insert(together_options.end(), {"--agents-per-process", "4"});
  const fs::path dds = run(scenario("small.toml"), options);
  const fs::path embedded = run(scenario("small.toml"), embedded_options);
  const fs::path together = run(scenario("small.toml"), together_options);
  for (const std::string robot : {"1", "2", "3", "4"}) {
    const Ended ended = step_agent(embedded, {}, robot);
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.said, "equal: robot " + robot + ", controller paper, 2188 steps\n");
    const std::string file = "trace/robot_" + robot + ".trace";
    EXPECT_EQ(read_file(dds / file), read_file(embedded / file)) << robot;
    EXPECT_EQ(read_file(together / file), read_file(embedded / file)) << robot;
  }
  EXPECT_EQ(step_agent(dds, {"--controller", "paper"}).exit_code, 0);
}

TEST_F(StepAgent, FindsThatALibraryThatHearsSeesAndDrawsAnswersTheSame) {
  for (const std::string& library : {kBraitenberg, kChatterer}) {
    const fs::path traced = run_embedded(scenario("small.toml"), {"--controller", library});
    const Ended ended = step_agent(traced);
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_THAT(ended.said, ContainsRegex("^equal: robot 3, controller [a-z]*, 313 steps\n$"));
  }
}

TEST_F(StepAgent, NamesTheFirstStepThatAChangedParameterAnswersOtherwise) {
  const std::string library = "library = \"" + kBraitenberg + "\"\n";
  const fs::path traced = run_embedded(scenario_with(library + "sight_m = 1.5\n"));
  const Ended slower = step_agent(traced, {"--scenario", scenario_with(library + "cruise_mps = 0.4\n")});
  EXPECT_EQ(slower.exit_code, 1);
  EXPECT_THAT(slower.said, ContainsRegex("^step 1 \\(0\\.000 s\\): robot 3 answer\\.left_mps: "));
  EXPECT_THAT(slower.said, HasSubstr("; answer.right_mps: ")) << "all that differs, in one line";
  EXPECT_EQ(std::count(slower.said.begin(), slower.said.end(), '\n'), 1) << slower.said;
  const Ended near = step_agent(traced, {"--scenario", scenario_with(library + "sight_m = 1.4\n")});
  EXPECT_EQ(near.exit_code, 1);
  EXPECT_THAT(near.said, ContainsRegex("^step [0-9]+ \\([0-9.]+ s\\): robot 3 answer\\.(left|right)_mps: "
                                       "-?[0-9.e-]+ \\| -?[0-9.e-]+"));
}

TEST_F(StepAgent, ComparesAllThatAControllerAnswers) {
  const fs::path traced = run_embedded(scenario("small.toml"), {"--controller", kFaulty});
  const Ended ended = step_agent(traced, {"--controller", kChatterer});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.said, StartsWith("step 1 (0.000 s): robot 3 answer.left_mps: 0.1 | "));
  EXPECT_EQ(std::count(ended.said.begin(), ended.said.end(), '|'), 4)
      << "the other wheel, the gripper, the number of frames";
}

TEST_F(StepAgent, NamesTheVeryStepThatDiffers) {
  const fs::path traced = run_embedded(scenario("small.toml"), {"--controller", kBraitenberg});
  const fs::path file = traced / "trace/robot_3.trace";
  std::string trace = read_file(file);
  // The lowest bit of the left speed of step 100. Nobody sends: a step has 324 bytes of inputs, 44 of answer.
  trace[trace.find('\n') + 1 + std::size_t{99} * (324 + 44) + 324 + 4] ^= 1;
  write_file(file, trace);
  const Ended ended = step_agent(traced);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.said, ContainsRegex("^step 100 \\(3\\.168 s\\): robot 3 answer\\.left_mps: "
                                        "-?[0-9.e-]+ \\| -?[0-9.e-]+\n$"));
}

TEST_F(StepAgent, RepeatsAFaultInTheStepInWhichTheRunHadIt) {
  const fs::path scenario = scenario_with("at_step = 40\nfault = \"throws\"\n");
  const fs::path traced = run_embedded(scenario, {"--controller", kFaulty}, 1);
  const Ended ended = step_agent(traced, {}, "2");
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.said,
              HasSubstr("controller faulty, robot 2, step 40 (1.248 s): threw an exception: no such cell"));
  const Ended sound =
      step_agent(traced, {"--scenario", scenario_with("library = \"" + kFaulty + "\"\n")}, "2");
  EXPECT_EQ(sound.exit_code, 0) << sound.said;
  EXPECT_THAT(sound.said, HasSubstr("robot_2.trace: has no answer to step 40\n"));
  EXPECT_THAT(sound.said, HasSubstr("equal: robot 2, controller faulty, 39 steps\n"));
}

TEST_F(StepAgent, EndsWithCodeTwoAndOneLineWhenTheControllerFails) {
  const fs::path traced = run_embedded(scenario("small.toml"));
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"nan", "step 1 (0.000 s): wheel speeds nan and 0.100000 m/s are not finite"},
      {"exits", "controller faulty, robot 2, step 1 (0.000 s): has called exit()"},
      {"hangs", "controller faulty, robot 2, step 1 (0.000 s): has not returned for 10 s"},
      {"constructor", "cannot be made: no map"},
      {"constructor_exits", "by exit code 0"}};
  for (const auto& [fault, said] : faults) {
    const fs::path faulty =
        scenario_with("at_step = 1\nfault = \"" + fault + "\"\nlibrary = \"" + kFaulty + "\"\n");
    const Ended ended = step_agent(traced, {"--scenario", faulty}, "2");
    EXPECT_EQ(ended.exit_code, 2) << fault;
    EXPECT_THAT(ended.said, HasSubstr(said));
    // The controller that hangs says so itself, for tests that wait for it.
    EXPECT_EQ(std::count(ended.said.begin(), ended.said.end(), '\n'), fault == "hangs" ? 2 : 1) << ended.said;
  }
}

TEST_F(StepAgent, ShowsOneStepWhole) {
  const fs::path scenario = scenario_with("library = \"" + kChatterer + "\"\n");
  const fs::path traced = run_embedded(scenario);
  const Ended same = step_agent(traced, {"--step", "3"});
  EXPECT_EQ(same.exit_code, 0) << same.said;
  EXPECT_THAT(same.said, StartsWith("step 3 (0.064 s): robot 3 was given\n  position_m "));
  for (const char* name : {"sonar_range_m", "left_wheel_rad", "heard"})
    EXPECT_THAT(same.said, HasSubstr("\n  " + std::string{name} + "  "));
  EXPECT_THAT(same.said, ContainsRegex("\nanswer in the run\n  left_mps +[-0-9.e]+\n"));
  EXPECT_THAT(same.said, ContainsRegex("\nanswer of controller chatterer\n  left_mps +[-0-9.e]+\n"));
  EXPECT_THAT(same.said, ContainsRegex("\n  frame_1 +channel 0, 1 bytes: [0-9a-f][0-9a-f]\n"));

  const Ended other = step_agent(traced, {"--step", "3", "--controller", kBraitenberg});
  EXPECT_EQ(other.exit_code, 1) << other.said;
  EXPECT_THAT(other.said, HasSubstr("\nanswer of controller braitenberg\n"));
  const Ended none = step_agent(traced, {"--step", "99999"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.said, ContainsRegex("robot_3.trace: has no step 99999, its steps are 1 to 31[0-9]\n"));
}

TEST_F(StepAgent, ShowsWhatAControllerWasGivenThatFailsInThatStep) {
  const fs::path faulty = scenario_with("at_step = 40\nfault = \"crashes\"\nlibrary = \"" + kFaulty + "\"\n");
  const fs::path traced = run_embedded(scenario("small.toml"));
  const Ended ended = step_agent(traced, {"--scenario", faulty, "--step", "40"}, "2");
  EXPECT_EQ(ended.exit_code, 128 + SIGSEGV);
  EXPECT_THAT(ended.said, StartsWith("step 40 (1.248 s): robot 2 was given\n"));
  EXPECT_THAT(ended.said, HasSubstr("robot 2, step 40 (1.248 s): ends the process by SIGSEGV"));
}

/// As at the prompt of a debugger. `script` gives the program a terminal.
TEST_F(StepAgent, HasNoDeadlineAtATerminal) {
  const fs::path traced = run_embedded(scenario("small.toml"));
  const fs::path faulty = scenario_with("at_step = 1\nfault = \"hangs\"\nlibrary = \"" + kFaulty + "\"\n");
  const std::string line = (fs::path{CARAVAN_BIN_DIR} / "caravan").string() + " step-agent " +
                           traced.string() + " --robot 2 --scenario " + faulty.string();
  test::PatientProcess process{{"/usr/bin/script", "-q", "-e", "-c", line, "/dev/null"}, folder_ / "log"};
  ASSERT_TRUE(process.prints("faulty hangs", kPatience)) << process.output();
  EXPECT_EQ(process.wait(12s), std::nullopt) << "10 s are over: " << process.output();
  process.signal(SIGTERM);
  process.wait(kPatience);
}

TEST_F(StepAgent, IsInterruptedAtOnceWhileAStepDoesNotReturn) {
  const fs::path traced = run_embedded(scenario("small.toml"));
  const fs::path faulty = scenario_with("at_step = 1\nfault = \"hangs\"\nlibrary = \"" + kFaulty + "\"\n");
  Process process{{"caravan", "step-agent", traced, "--robot", "2", "--scenario", faulty}, folder_ / "log"};
  ASSERT_TRUE(process.prints("faulty hangs", kPatience)) << process.output();
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(kPatience), 130) << process.output();
  EXPECT_EQ(process.output(), "faulty hangs\n");
}

TEST_F(StepAgent, NamesWhatIsMissingOrDamaged) {
  const fs::path bare = run(scenario("small.toml"), {"--engine", "embedded", "--max-time", "1"});
  const fs::path traced = run_embedded(scenario("small.toml"));
  const auto complaint = [&](const fs::path& run, const std::vector<std::string>& more,
                             const std::string& robot) {
    const Ended ended = step_agent(run, more, robot);
    EXPECT_EQ(ended.exit_code, 2) << ended.said;
    EXPECT_EQ(std::count(ended.said.begin(), ended.said.end(), '\n'), 1) << ended.said;
    return ended.said;
  };
  EXPECT_THAT(complaint(bare, {}, "3"),
              HasSubstr("/trace/robot_3.trace: cannot be read; `caravan run --trace` records one"));
  EXPECT_THAT(complaint(traced, {}, "5"), HasSubstr(": has no robot 5, its robots are 1 to 4"));
  EXPECT_THAT(complaint(traced, {}, "0"), HasSubstr("has no robot 0"));
  EXPECT_THAT(complaint(folder_ / "nowhere", {}, "3"), HasSubstr("nowhere/scenario.toml"));
  EXPECT_THAT(complaint(traced, {"--controller", "missing.so"}, "3"),
              HasSubstr("missing.so: there is no such file"));

  fs::copy_file(traced / "trace/robot_1.trace", traced / "trace/robot_2.trace",
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(complaint(traced, {}, "2"),
              HasSubstr("/trace/robot_2.trace: is the trace of robot 1, not of robot 2"));
  fs::remove(traced / "trace/robot_2.trace");
  ASSERT_EQ(mkfifo((traced / "trace/robot_2.trace").c_str(), 0600), 0);
  EXPECT_THAT(complaint(traced, {}, "2"), HasSubstr("/trace/robot_2.trace: is no regular file"));

  const fs::path file = traced / "trace/robot_3.trace";
  const std::string whole = read_file(file);
  const std::size_t begin = whole.find('\n') + 1;
  write_file(file, whole.substr(0, begin + 2000));
  const Ended cut = step_agent(traced);
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_THAT(cut.said, ContainsRegex("robot_3\\.trace: is incomplete after step [0-9]\n"));
  write_file(file, whole.substr(0, begin));
  EXPECT_THAT(complaint(traced, {}, "3"), HasSubstr("robot_3.trace: has no whole step"));
  write_file(file, whole.substr(0, begin) + std::string{"\1\0\0\0x", 5});
  EXPECT_THAT(complaint(traced, {}, "3"), HasSubstr("is damaged in step 1: a step has too few bytes"));
  write_file(file, "caravan trace 1 world 4\n");
  EXPECT_THAT(complaint(traced, {}, "3"), HasSubstr("is not a robot trace"));
}

/// As a bridge of a real robot and a service manager do: the same session, another process.
TEST_F(StepAgent, ComparesTheLastControllerOfARobotWhoseAgentWasRestarted) {
  const runtime::DomainLock lock{std::nullopt};
  const runtime::BusConfig bus_config{.role = "test", .domain = lock.domain()};
  fs::create_directory(folder_ / "trace");
  fs::copy_file(scenario("small.toml"), folder_ / "scenario.toml");
  const std::vector<std::string> line = {"robot_agent",
                                         "--scenario",
                                         scenario("small.toml"),
                                         "--domain",
                                         std::to_string(lock.domain()),
                                         "--lease",
                                         std::to_string(short_lease_s()),
                                         "--robot",
                                         "3",
                                         "--trace",
                                         folder_ / "trace"};
  runtime::Bus bus{bus_config};
  const Collector<msg::RobotCommandPubSubType> commands{bus_config, idl::kCommand, 3};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 3);
  const auto answers = [&](int step) {
    msg::SensorFrame frame;
    frame.stamp(idl::to_wire(step * 32ms));
    frame.session(7);
    frame.gps_x_m(0.01 * step);
    frame.compass_yaw_rad(0.02 * step);
    sensors.write(frame);
    return commands.first([&](const msg::RobotCommand& one) { return one.stamp() == frame.stamp(); })
        .has_value();
  };
  {
    Process first{line, folder_ / "first.log"};
    for (int step = 0; step < 10; ++step) ASSERT_TRUE(answers(step)) << first.output();
    first.signal(SIGKILL);
    ASSERT_EQ(first.wait(kPatience), 128 + SIGKILL);
  }
  const Ended killed = step_agent(folder_.path());
  EXPECT_EQ(killed.said, "equal: robot 3, controller paper, 10 steps\n") << "nothing is lost";
  Process second{line, folder_ / "second.log"};
  for (int step = 10; step < 13; ++step) ASSERT_TRUE(answers(step)) << second.output();
  second.signal(SIGTERM);
  ASSERT_EQ(second.wait(kPatience), 0) << second.output();

  // DDS may have given it the last frames of before as well.
  EXPECT_THAT(step_agent(folder_.path()).said,
              ContainsRegex("^equal: robot 3, controller paper, [3-9] steps\n$"));

  std::vector<std::string> bad = line;
  bad.back() = folder_ / "nowhere";
  Process refused{bad, folder_ / "refused.log"};
  EXPECT_EQ(refused.wait(kPatience), 2);
  EXPECT_THAT(refused.output(), HasSubstr("nowhere is not a folder"));
}

}  // namespace
}  // namespace caravan::test
