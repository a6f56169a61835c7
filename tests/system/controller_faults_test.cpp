// SPDX-License-Identifier: Apache-2.0
// Faults of processes whose controller comes from outside: agents that are killed and started again, scripts
// of the deployment kit, and controllers that do not return or that crash.
#include <gmock/gmock.h>
#include <signal.h>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/patient_deployment.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

const std::filesystem::path kLibraries =
    std::filesystem::path{CARAVAN_BIN_DIR}.parent_path() / "tests/controllers";

class ControllerFaults : public PatientDeployment {
 protected:
  void start_all(const std::string& changes, double lease_s = short_lease_s()) {
    deploy({.scenario = scenario("small.toml"),
            .changes = "experiment.items = 1000\n" + changes,
            .controller = kLibraries / "chatterer.so",
            .lease_s = lease_s,
            .hold_start = true});
    ASSERT_TRUE(does("start all"));
  }
  /// A run in which an agent dies at a step, and is started again or not.
  std::string digest_with_a_death() {
    start_all("experiment.max_time_s = 30.0");
    EXPECT_TRUE(does("radio cut 1 2 at 150"));
    EXPECT_TRUE(does("go"));
    EXPECT_TRUE(does("hold_at 400"));
    EXPECT_TRUE(does("kill robot 3"));
    EXPECT_TRUE(does("resume"));
    EXPECT_TRUE(happens("the time runs out", "state is finished"));
    return seen().digest;
  }
};

TEST_F(ControllerFaults, AKilledAgentIsMissedAndBeginsAnewWithItsController) {
  start_all("");
  ASSERT_TRUE(does("go"));
  ASSERT_TRUE(happens("everybody drives", "step > 20 and members is 4 and events began 2 is 1"));
  ASSERT_TRUE(does("kill robot 2"));
  EXPECT_TRUE(happens("it is missed", "gone has \"robot 2\" and members is 3"));
  ASSERT_TRUE(does("start robot 2"));
  EXPECT_TRUE(happens("it is back", "gone is none and members is 4"));
  EXPECT_TRUE(happens("its controller is a new one", "events began 2 is 2 and events began 1 is 1"));
  EXPECT_TRUE(happens("the run goes on", "step > " + std::to_string(seen().step + 100)));
}

TEST_F(ControllerFaults, ADeathAtAStepGivesTheSameRunEveryTime) {
  const std::string first = digest_with_a_death();
  EXPECT_EQ(first.size(), 16U);
  EXPECT_EQ(digest_with_a_death(), first);
}

class ControllerScript : public ::testing::Test {
 protected:
  ScratchFolder folder_;
};

TEST_F(ControllerScript, RestartsAnAgentWhoseControllerTheCommandLineNames) {
  write_file(folder_ / "script.toml",
             "scenario = \"" + scenario("small.toml").string() +
                 "\"\n[[step]]\ndo = \"start all\"\nexpect = \"step > 20\"\nwithin_s = 60\n"
                 "[[step]]\ndo = \"kill robot 2\"\nexpect = \"gone has \\\"robot 2\\\"\"\nwithin_s = 60\n"
                 "[[step]]\ndo = \"start robot 2\"\nexpect = \"gone is none and events began 2 > 1\"\n"
                 "within_s = 60\n");
  Process process{{"caravan", "deploy", folder_ / "script.toml", "--out", folder_ / "out", "--controller",
                   kLibraries / "chatterer.so"},
                  folder_ / "log"};
  EXPECT_EQ(process.wait(180s), 0) << process.output();
}

/// robot_agent as started by hand, with a controller that breaks a rule.
class FaultyAgent : public ::testing::Test {
 protected:
  [[nodiscard]] std::unique_ptr<Process> start(const std::string& fault) const {
    write_file(folder_ / "mine.toml",
               read_file(scenario("small.toml")) + "\n[controller]\nfault = \"" + fault + "\"\n");
    return std::make_unique<Process>(
        std::vector<std::string>{"robot_agent", "--scenario", folder_ / "mine.toml", "--domain",
                                 std::to_string(lock_.domain()), "--robot", "2", "--controller",
                                 kLibraries / "faulty.so"},
        folder_ / "agent.log");
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(FaultyAgent, EndsWhenAConstructorDoesNotReturn) {
  const auto agent = start("constructor_hangs");
  EXPECT_EQ(agent->wait(kPatience), 2);
  EXPECT_THAT(agent->output(),
              HasSubstr("controller faulty, robot 2: its constructor has not returned for 10 s"));
}

TEST_F(FaultyAgent, IsStoppedAtOnceWhileAConstructorDoesNotReturn) {
  const auto agent = start("constructor_hangs");
  ASSERT_TRUE(agent->prints("faulty hangs", kPatience)) << agent->output();
  agent->signal(SIGTERM);
  EXPECT_EQ(agent->wait(kPatience), 0);
  EXPECT_THAT(agent->output(), HasSubstr("its constructor has not returned, and this process is stopped"));
}

TEST_F(FaultyAgent, NamesAConstructorThatCrashes) {
  const auto agent = start("constructor_aborts");
  EXPECT_EQ(agent->wait(kPatience), 128 + SIGABRT);
  EXPECT_THAT(agent->output(),
              HasSubstr("controller faulty, robot 2, its constructor: ends the process by SIGABRT"));
}

}  // namespace
}  // namespace caravan::test
