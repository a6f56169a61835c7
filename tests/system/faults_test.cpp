// SPDX-License-Identifier: Apache-2.0
// What happens in the field, done to real processes. docs/faults.md lists these tests and what they would
// catch.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "deploy/kit/deployment_test.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using deploy::Condition;
using deploy::Seen;

/// The small room with the destination in sight of the start: soon everybody has a path and exchanges it,
/// again and again.
constexpr const char* kBusy = R"(
robots.destination_m = [-1.0, -4.5]
algorithm.sharing_starts_s = 2.0
algorithm.recontact_after_s = 2.0
experiment.items = 100000
experiment.max_time_s = 100000.0
)";

/// Two robots that stand to exchange.
struct Pair {
  std::uint32_t lower = 0;
  std::uint32_t higher = 0;
};

class Faults : public deploy::DeploymentTest {
 protected:
  void start_busy(const std::string& more = "", double lease_s = 1.0, bool hold_start = false) {
    deploy({.scenario = scenario("small.toml"),
            .changes = kBusy + more,
            .lease_s = lease_s,
            .hold_start = hold_start});
  }
  void start_all_busy(const std::string& more = "", double lease_s = 1.0) {
    start_busy(more, lease_s);
    ASSERT_TRUE(does("start all"));
    ASSERT_TRUE(comes("everybody comes", "step > 20 and members is 4", 30s));
  }
  [[nodiscard]] ::testing::AssertionResult goes_on() {
    const std::string later = "step > " + std::to_string(seen().step + 200);
    return comes("the run goes on", later, 20s);
  }
  /// Steps until two robots stand to exchange that both did not before.
  Pair step_to_an_exchange() {
    const auto standing = [](const Seen& now) {
      std::vector<std::uint32_t> robots;
      for (const auto& [robot, one] : now.robots) {
        if (one.is_member && one.activity == "exchanging") robots.push_back(robot);
      }
      return robots;
    };
    EXPECT_TRUE(does("pause"));
    EXPECT_TRUE(comes("it is paused", "state is paused", 10s));
    const Condition nobody{"nobody exchanges", [&](const Seen& now) { return standing(now).empty(); }};
    const Condition two{"two stand", [&](const Seen& now) { return standing(now).size() >= 2; }};
    const deploy::Result quiet = deployment().step_until(nobody, 1000);
    EXPECT_TRUE(quiet.good) << quiet.text;
    const deploy::Result met = deployment().step_until(two, 3000);
    EXPECT_TRUE(met.good) << met.text;
    const auto robots = standing(seen());
    return robots.size() < 2 ? Pair{1, 2} : Pair{robots[0], robots[1]};
  }
  /// Suspends a process while it waits. One that is stopped in the middle of a send or a receive may hold a
  /// lock in shared memory that all others need: a limit of DDS, not what these tests are about.
  void suspend_at_rest(const std::string& who) {
    ASSERT_TRUE(does("pause"));
    ASSERT_TRUE(comes("it is paused", "state is paused", 10s));
    ASSERT_TRUE(does("suspend " + who));
    if (who == "world") return;
    ASSERT_TRUE(does("resume"));
  }
  void expect_back_and_working(std::uint32_t robot) {
    const std::string name = "robot " + std::to_string(robot);
    const std::string number = std::to_string(robot);
    EXPECT_TRUE(
        comes(name + " is back", "gone lacks \"" + name + "\" and member " + number + " is yes", 15s));
    EXPECT_TRUE(comes(name + " has a path again", "mode " + number + " is transport", 30s));
  }
};

/// Which of the two is killed, and how many steps after both have stopped to exchange.
struct Moment {
  bool higher = false;
  int steps = 0;
};
class KilledInAnExchange : public Faults, public ::testing::WithParamInterface<Moment> {};

TEST_P(KilledInAnExchange, IsNoticedFreesItsPartnerAndComesBackWithoutItsPath) {
  start_all_busy();
  const Pair pair = step_to_an_exchange();
  if (GetParam().steps > 0) {
    const std::string there = std::to_string(seen().step + static_cast<std::uint64_t>(GetParam().steps));
    ASSERT_TRUE(does("step " + std::to_string(GetParam().steps)));
    ASSERT_TRUE(comes("some steps later", "state is paused and step is " + there, 10s));
  }
  const std::uint32_t killed = GetParam().higher ? pair.higher : pair.lower;
  const std::uint32_t partner = GetParam().higher ? pair.lower : pair.higher;
  const std::string name = "robot " + std::to_string(killed);
  ASSERT_TRUE(does("kill " + name));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(comes("its loss is noticed", "gone has \"" + name + "\" and members is 3", 8s));
  EXPECT_TRUE(comes("its partner is free again",
                    "activity " + std::to_string(partner) + " is not exchanging and member " +
                        std::to_string(partner) + " is yes",
                    10s));
  EXPECT_TRUE(goes_on());

  // It keeps nothing. The world is held meanwhile, so that the first that it says of itself stands; and it is
  // put where it does not see the destination, with some steps for the frames of the old place to be
  // replaced.
  ASSERT_TRUE(does("pause"));
  ASSERT_TRUE(does("teleport " + std::to_string(killed) + " 4.5 4.5"));
  ASSERT_TRUE(does("step 8"));
  ASSERT_TRUE(comes("it is paused", "state is paused", 10s));
  ASSERT_TRUE(does("start " + name));
  EXPECT_TRUE(comes("it starts from its initial state",
                    "gone lacks \"" + name + "\" and mode " + std::to_string(killed) +
                        " is explore and path " + std::to_string(killed) + " is none",
                    15s));
  ASSERT_TRUE(does("resume"));
  expect_back_and_working(killed);
}

INSTANTIATE_TEST_SUITE_P(Moments, KilledInAnExchange,
                         ::testing::Values(Moment{true, 0}, Moment{false, 1}, Moment{true, 2},
                                           Moment{false, 4}),
                         [](const auto& one) {
                           return std::string{one.param.higher ? "Primary" : "Secondary"} + "After" +
                                  std::to_string(one.param.steps);
                         });

TEST_F(Faults, SeveralKilledAtOnceAreMissedAndTakenBack) {
  start_all_busy();
  ASSERT_TRUE(does("kill robot 1,3,4"));
  EXPECT_TRUE(
      comes("all are missed", "gone has \"robot 1\" and gone has \"robot 3\" and gone has \"robot 4\"", 8s));
  EXPECT_TRUE(comes("one is left", "members is 1", 8s));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("start robot 1,3,4"));
  EXPECT_TRUE(comes("all are back", "gone is none and members is 4", 15s));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, ARunThatLostAllItsAgentsGoesOnWithNewOnes) {
  start_all_busy();
  ASSERT_TRUE(does("kill robots"));
  EXPECT_TRUE(comes("all are missed", "members is 0", 8s));
  ASSERT_TRUE(does("start robots"));
  EXPECT_TRUE(comes("all are back", "gone is none and members is 4", 15s));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, AgentsThatAreReplacedAtOnceGoOn) {
  start_all_busy();
  ASSERT_TRUE(does("restart robots"));
  EXPECT_TRUE(comes("they begin anew", "gone is none and members is 4 and disturbed is yes", 20s));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, AKilledWorldBeginsANewSessionWithTheSameAgents) {
  start_all_busy();
  EXPECT_TRUE(comes(
      "everybody has a path",
      "mode 1 is transport and mode 2 is transport and mode 3 is transport and mode 4 is transport", 20s));
  const std::uint64_t before = seen().step;
  ASSERT_TRUE(does("restart world"));
  EXPECT_TRUE(comes("a new session begins", "sessions is 2 and members is 4", 20s));
  EXPECT_LT(seen().time_s, 0.032 * static_cast<double>(before)) << "it begins anew";
  EXPECT_TRUE(comes("it goes on", "step > 100", 20s));
  for (const std::string robot : {"1", "2", "3", "4"}) {
    EXPECT_TRUE(comes("nobody was restarted", "process robot " + robot + " is running", 0s));
    const std::string log = deploy::read_whole_file(seen().processes.at("robot " + robot).log);
    const std::size_t first = log.find("starting from the initial state");
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(log.find("starting from the initial state", first + 1), std::string::npos) << log;
  }
  EXPECT_TRUE(comes("the run is whole", "disturbed is no", 5s));
  EXPECT_TRUE(comes("the radio works", "exchanges 1 > 0 and exchanges 2 > 0", 30s));
}

TEST_F(Faults, AKilledRadioIsMissedAndTakenBack) {
  start_all_busy();
  ASSERT_TRUE(comes("they exchange", "exchanges 1 > 0", 30s));
  ASSERT_TRUE(does("kill radio"));
  EXPECT_TRUE(comes("it is missed", "gone has radio", 8s));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(comes(
      "nobody stands for ever",
      [](const Seen& now) {
        return std::none_of(now.robots.begin(), now.robots.end(),
                            [](const auto& one) { return one.second.activity == "exchanging"; });
      },
      10s));
  const std::uint32_t exchanges = seen().robots.at(1).exchanges;
  ASSERT_TRUE(does("start radio"));
  EXPECT_TRUE(comes("it is taken back", "gone is none", 15s));
  EXPECT_TRUE(comes("they exchange again", "exchanges 1 > " + std::to_string(exchanges), 30s));
}

TEST_F(Faults, WithoutARadioTheSwarmStartsAloneAndARadioMayComeLate) {
  start_busy();
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start robots"));
  EXPECT_TRUE(comes("it starts without", "gone has radio and step > 100", 30s));
  ASSERT_TRUE(does("start radio"));
  EXPECT_TRUE(comes("they exchange", "gone is none and exchanges 1 > 0", 30s));
}

TEST_F(Faults, AnAgentSuspendedForFiveSecondsComesBack) {
  start_all_busy();
  const auto since = std::chrono::steady_clock::now();
  suspend_at_rest("robot 2");
  EXPECT_TRUE(comes("it is missed", "gone has \"robot 2\" and members is 3", 8s));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(comes(
      "5 s are over", [&](const Seen&) { return std::chrono::steady_clock::now() - since > 5s; }, 20s));
  ASSERT_TRUE(does("continue robot 2"));
  EXPECT_TRUE(comes("it is back", "gone is none and members is 4", 15s));
  EXPECT_TRUE(comes("it has begun anew", "log robot 2 has \"beginning anew\"", 15s));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(comes("it exchanges", "exchanges 2 > " + std::to_string(seen().robots.at(2).exchanges), 30s));
}

TEST_F(Faults, ARadioSuspendedForLongerThanItsLeaseComesBack) {
  start_all_busy();
  const auto since = std::chrono::steady_clock::now();
  suspend_at_rest("radio");
  EXPECT_TRUE(comes("it is missed", "gone has radio", 8s));
  ASSERT_TRUE(comes(
      "3 s are over", [&](const Seen&) { return std::chrono::steady_clock::now() - since > 3s; }, 20s));
  ASSERT_TRUE(does("continue radio"));
  EXPECT_TRUE(comes("it is back", "gone is none and members is 4", 15s));
  const deploy::Seen now = seen();
  for (const std::string robot : {"1", "2", "3", "4"}) {
    const std::uint32_t exchanges = now.robots.at(static_cast<std::uint32_t>(std::stoul(robot))).exchanges;
    EXPECT_TRUE(comes("everybody hears it", "exchanges " + robot + " > " + std::to_string(exchanges), 30s));
  }
}

TEST_F(Faults, AWorldSuspendedForLongerThanItsLeaseEndsAndSaysWhy) {
  start_all_busy();
  const auto since = std::chrono::steady_clock::now();
  suspend_at_rest("world");
  ASSERT_TRUE(comes(
      "3 s are over", [&](const Seen&) { return std::chrono::steady_clock::now() - since > 3s; }, 20s));
  ASSERT_TRUE(does("continue world"));
  EXPECT_TRUE(comes("it ends", "process world is ended and exit world is 1", 15s));
  EXPECT_TRUE(comes("its log tells", "log world has \"longer than the lease\"", 1s));
  ASSERT_TRUE(does("start world"));
  EXPECT_TRUE(comes("another begins", "sessions is 2 and members is 4", 20s));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, AWorldSuspendedForLessThanItsLeaseGoesOn) {
  start_all_busy("", 8.0);
  const auto since = std::chrono::steady_clock::now();
  suspend_at_rest("world");
  ASSERT_TRUE(comes(
      "3 s are over", [&](const Seen&) { return std::chrono::steady_clock::now() - since > 3s; }, 20s));
  ASSERT_TRUE(does("continue world"));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(comes("nobody is missed", "gone is none and members is 4", 15s));
}

TEST_F(Faults, AHungAgentIsNamedAndWaitedFor) {
  start_all_busy("experiment.on_hung = \"wait\"\n", 60.0);  // nobody is gone within a minute: it hangs
  suspend_at_rest("robot 3");
  EXPECT_TRUE(comes("it is named", "hung has \"robot 3\" and gone is none", 8s));
  const std::uint64_t step = seen().step;
  EXPECT_FALSE(comes("the world waits", "step > " + std::to_string(step), 1s));
  ASSERT_TRUE(does("continue robot 3"));
  EXPECT_TRUE(
      comes("it goes on with it", "hung is none and members is 4 and step > " + std::to_string(step), 15s));
  EXPECT_TRUE(comes("the log tells", "log world has \"alive but not answering: robot 3\"", 0s));
}

TEST_F(Faults, AHungAgentIsCoastedPastUntilItAnswersAgain) {
  start_all_busy("experiment.on_hung = \"coast\"\n", 60.0);
  suspend_at_rest("robot 3");
  EXPECT_TRUE(comes("it is named and left out", "hung has \"robot 3\" and members is 3", 8s));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("continue robot 3"));
  EXPECT_TRUE(comes("it is back", "hung is none and members is 4", 15s));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, ARobotIsTakenOutOfTheWorldAndPutBackIn) {
  start_all_busy();
  ASSERT_TRUE(does("remove 3"));
  EXPECT_TRUE(comes("it is out", "removed has \"robot 3\" and members is 3 and gone is none", 10s));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("pause"));
  ASSERT_TRUE(does("spawn 3 4.5 4.5"));
  ASSERT_TRUE(does("step"));
  EXPECT_TRUE(comes("its agent is awaited at once", "removed is none and members is 4", 10s));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Faults, ARobotIsSpawnedBeforeItHasAnAgent) {
  start_all_busy();
  ASSERT_TRUE(does("kill robot 3"));
  EXPECT_TRUE(comes("its loss is noticed", "gone has \"robot 3\"", 8s));
  ASSERT_TRUE(does("remove 3"));
  EXPECT_TRUE(comes("it is out", "removed has \"robot 3\" and gone is none", 10s));
  ASSERT_TRUE(does("spawn 3 4.5 4.5"));
  EXPECT_TRUE(comes("it is missing", "missing has \"robot 3\" and removed is none and members is 3", 10s));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("start robot 3"));
  EXPECT_TRUE(comes("its agent has come", "missing is none", 15s));
  expect_back_and_working(3);
}

TEST_F(Faults, AgentsMayComeBeforeTheWorld) {
  start_busy();
  ASSERT_TRUE(does("start robot 4"));
  ASSERT_TRUE(does("start robot 1-3"));
  ASSERT_TRUE(comes("an agent waits", "log robot 4 has \"waiting for the world\"", 20s));
  ASSERT_TRUE(does("start radio"));
  ASSERT_TRUE(does("start world"));
  EXPECT_TRUE(comes("it starts", "step > 50 and members is 4 and disturbed is no", 30s));
}

TEST_F(Faults, FifteenAgentsMayComeAtOnce) {
  deploy({.scenario = scenario("paper.toml"), .lease_s = 5.0});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start radio"));
  ASSERT_TRUE(comes("nobody is there", "missing has \"robot 15\"", 20s));
  ASSERT_TRUE(does("start robots"));
  EXPECT_TRUE(comes("it starts", "step > 50 and members is 15 and disturbed is no", 60s));
}

TEST_F(Faults, FifteenAgentsMayComeOneByOne) {
  deploy({.scenario = scenario("paper.toml"), .lease_s = 5.0});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start radio"));
  for (int robot = 15; robot >= 1; --robot) {
    ASSERT_TRUE(does("start robot " + std::to_string(robot)));
    ASSERT_TRUE(comes("one more",
                      "missing lacks \"robot " + std::to_string(robot) + "\" and state is not absent", 30s));
  }
  EXPECT_TRUE(comes("it starts", "step > 50 and members is 15 and disturbed is no", 60s));
}

TEST_F(Faults, AgentsMayComeOneByOneAndTheWorldSaysWhoIsMissing) {
  start_busy();
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(comes("nobody is there", "missing has \"robot 1\" and missing has \"robot 4\"", 20s));
  ASSERT_TRUE(does("start radio"));
  for (const std::string robot : {"1", "2", "3"}) {
    ASSERT_TRUE(does("start robot " + robot));
    ASSERT_TRUE(comes("one more", "state is waiting and missing lacks \"robot " + robot + "\"", 20s));
  }
  ASSERT_TRUE(does("start robot 4"));
  EXPECT_TRUE(comes("it starts", "step > 50 and members is 4 and disturbed is no", 30s));
}

}  // namespace
}  // namespace caravan::test
