// SPDX-License-Identifier: Apache-2.0
// A run that stands still reports what it waits for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;

class StandingStill : public ::testing::Test {
 protected:
  explicit StandingStill(const std::string& scenario_text = read_file(scenario("small.toml")))
      : launcher_{command(scenario_text), folder_ / "launcher.log"} {}
  [[nodiscard]] std::vector<std::string> command(const std::string& scenario_text) const {
    write_file(folder_ / "scenario.toml", scenario_text);
    return {"caravan",
            "run",
            folder_ / "scenario.toml",
            "--out",
            folder_ / "out",
            "--items",
            "100000",
            "--max-time",
            "1000000",
            "--domain",
            std::to_string(lock_.domain()),
            "--quiet"};
  }
  void SetUp() override { ASSERT_TRUE(goes_on()) << launcher_.output(); }
  void TearDown() override {
    launcher_.signal(SIGINT);
    EXPECT_EQ(launcher_.wait(kPatience), 130) << launcher_.output();
    EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
    EXPECT_THAT(left_in_shared_memory(lock_.domain()), IsEmpty());
  }
  /// Whether the records grow from now on.
  [[nodiscard]] bool goes_on() const {
    const auto rows = [this] {
      const std::string text = read_file(folder_ / "out/tracks.csv");
      return std::count(text.begin(), text.end(), '\n');
    };
    return eventually([&, before = rows()] { return rows() > before + 20; }, kPatience);
  }
  void ask(const std::vector<std::string>& action) const {
    std::vector<std::string> line{"caravan", "ctl", "--domain", std::to_string(lock_.domain())};
    line.insert(line.end(), action.begin(), action.end());
    Process ctl{line, folder_ / "ctl.log"};
    ASSERT_EQ(ctl.wait(kPatience), 0) << ctl.output();
  }
  void send(int signal, const std::string& program, const std::string& more = "") const {
    const pid_t pid = pid_in(lock_.domain(), program, more);
    ASSERT_GT(pid, 0) << program << " " << more;
    ASSERT_EQ(kill(pid, signal), 0);
  }
  void send_all_agents(int signal) const {
    for (const std::string robot : {"1", "2", "3", "4"}) send(signal, "robot_agent", "--robot " + robot);
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  Process launcher_;
};

TEST_F(StandingStill, APausedRunSaysSoAndOneWhoseAgentsAreSuspendedNamesThem) {
  ask({"pause"});
  EXPECT_TRUE(launcher_.prints("the run is paused", kPatience)) << launcher_.output();
  send_all_agents(SIGSTOP);  // while they wait, so that none of them holds a lock
  ask({"resume"});
  EXPECT_TRUE(launcher_.prints("robot 1, robot 2, robot 3, robot 4 ", kPatience)) << launcher_.output();
  EXPECT_TRUE(launcher_.prints("no other robot is left", kPatience)) << launcher_.output();
  send_all_agents(SIGCONT);
  EXPECT_TRUE(goes_on()) << launcher_.output();
}

/// At the lowest speed one step takes four minutes.
class StandingStillInLongSteps : public StandingStill {
 protected:
  StandingStillInLongSteps()
      : StandingStill{
            replaced(read_file(scenario("small.toml")), "[world]", "[world]\nstep_s = 0.25\nsubsteps = 8")} {}
};

TEST_F(StandingStillInLongSteps, ARunWhoseWorldWasMadeVerySlowSaysSoAndTheRange) {
  ask({"speed", "0.001"});
  EXPECT_TRUE(launcher_.prints("the world runs at 0.001 times real time", kPatience)) << launcher_.output();
  EXPECT_TRUE(launcher_.prints("(`caravan ctl speed` takes 0.001 to 1000, or max)", kPatience));
  ask({"speed", "1000"});
  EXPECT_TRUE(goes_on()) << "at once, not when the slow step is over" << launcher_.output();
}

TEST_F(StandingStill, ARunWhoseWorldSaysNothingNamesIt) {
  ask({"pause"});
  send(SIGSTOP, "world_server");
  EXPECT_TRUE(launcher_.prints("world_server has been silent for ", kPatience)) << launcher_.output();
}

}  // namespace
}  // namespace caravan::test
