// SPDX-License-Identifier: Apache-2.0
// The deployment test kit itself: what it does is repeatable, what fails is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "deploy/kit/deployment_test.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class DeploymentKit : public deploy::DeploymentTest {
 protected:
  /// The small scenario for 40 simulated seconds, with or without what people do to it.
  std::string digest_of_a_run(bool with_faults) {
    deploy({.scenario = scenario("small.toml"),
            .changes = "experiment.items = 1000\nexperiment.max_time_s = 40.0",
            .lease_s = 1.0,
            .hold_start = true});
    EXPECT_TRUE(does("start all"));
    if (with_faults) {
      EXPECT_TRUE(does("radio cut 1 2 at 150"));
      EXPECT_TRUE(does("teleport 1 5 0 1.5 at 200"));
      EXPECT_TRUE(does("remove 2 at 250"));
      EXPECT_TRUE(does("hold 4 at 300"));
      EXPECT_TRUE(does("spawn 2 5 -5 1.5 at 400"));
    }
    EXPECT_TRUE(does("go"));
    if (with_faults) {
      EXPECT_TRUE(does("hold_at 600"));
      EXPECT_TRUE(does("kill robot 3"));
      EXPECT_TRUE(does("resume"));
    }
    EXPECT_TRUE(comes("the time runs out", "state is finished", 40s));
    EXPECT_EQ(seen().disturbed, with_faults);
    return seen().digest;
  }
};

TEST_F(DeploymentKit, FaultsAtAStepGiveTheSameRunEveryTime) {
  const std::string first = digest_of_a_run(true);
  EXPECT_EQ(first.size(), 16U);
  EXPECT_EQ(digest_of_a_run(true), first);
  EXPECT_NE(digest_of_a_run(false), first);
}

TEST_F(DeploymentKit, TellsWhatItWaitedForAndWhatItSaw) {
  deploy({.scenario = scenario("small.toml")});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(comes("the world is up", "state is waiting", 20s));
  const deploy::Result result =
      deployment().expect("a robot comes", deploy::Condition{"missing lacks \"robot 3\""}, 300ms);
  EXPECT_FALSE(result.good);
  EXPECT_THAT(result.text, HasSubstr("a robot comes: not within 0.3"));
  EXPECT_THAT(result.text, HasSubstr("expected: missing lacks \"robot 3\""));
  EXPECT_THAT(result.text, HasSubstr("robot 1, robot 2, robot 3, robot 4]\n"));
  EXPECT_THAT(result.text, HasSubstr("world running;"));
  EXPECT_THAT(result.text, HasSubstr("logs: "));
}

TEST_F(DeploymentKit, LeavesNothingBehind) {
  std::uint32_t domain = 0;
  {
    const deploy::Deployment& made = deploy({.scenario = scenario("small.toml"), .lease_s = 1.0});
    domain = made.domain();
    ASSERT_TRUE(does("start all"));
    ASSERT_TRUE(comes("it runs", "step > 50", 20s));
    ASSERT_TRUE(does("kill robot 2,3"));
    ASSERT_TRUE(does("suspend robot 4"));
  }
  end_deployment();
  EXPECT_THAT(processes_in(domain), ::testing::IsEmpty());
  EXPECT_THAT(left_in_shared_memory(domain), ::testing::IsEmpty());
}

class DeployCommand : public ::testing::Test {
 protected:
  int run(const std::string& steps) {
    write_file(folder_ / "script.toml", "scenario = \"" + scenario("small.toml").string() + "\"\n" + steps);
    Process process{{"caravan", "deploy", folder_ / "script.toml", "--out", folder_ / "out"},
                    folder_ / "log"};
    const auto code = process.wait(60s);
    output_ = process.output();
    return code.value_or(-1);
  }
  ScratchFolder folder_;
  std::string output_;
};

TEST_F(DeployCommand, EndsWithZeroWhenEverythingComesAsExpected) {
  EXPECT_EQ(run("[[step]]\nname = \"it runs\"\ndo = \"start all\"\nexpect = \"step > 50\"\nwithin_s = 30\n"),
            0)
      << output_;
  EXPECT_THAT(read_file(folder_ / "out/junit.xml"), HasSubstr("name=\"it runs\" time="));
}

TEST_F(DeployCommand, EndsWithThreeWhenAnExpectationIsNotMet) {
  EXPECT_EQ(run("[[step]]\nname = \"it runs\"\ndo = \"start world\"\nexpect = \"step > 50\"\nwithin_s = 1\n"
                "[[step]]\nname = \"never reached\"\n"),
            3)
      << output_;
  const std::string report = read_file(folder_ / "out/junit.xml");
  EXPECT_THAT(report, HasSubstr("failures=\"1\" errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(report, HasSubstr("expected: step &gt; 50"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/world.log")) << "logs are kept";
}

TEST_F(DeployCommand, EndsWithTwoWhenTheScriptIsWrong) {
  EXPECT_EQ(run("[[step]]\ndo = \"explode\"\n"), 2);
  EXPECT_THAT(output_, HasSubstr("script.toml:3"));
}

}  // namespace
}  // namespace caravan::test
