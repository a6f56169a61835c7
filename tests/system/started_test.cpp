// SPDX-License-Identifier: Apache-2.0
// Processes and robots that start late, early, one by one or all at once, and robots that are removed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/system/support/faults.hpp"

namespace caravan::test {
namespace {

using Started = Faults;

/// A start that waits as long as it takes on a busy machine.
constexpr const char* kPatientStart = "experiment.start_timeout_s = 3600";

TEST_F(Started, WithoutARadioTheSwarmStartsAloneAndARadioMayComeLate) {
  start_busy();
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start robots"));
  EXPECT_TRUE(happens("it starts without", "gone has radio and step > 100"));
  ASSERT_TRUE(does("start radio"));
  EXPECT_TRUE(happens("they exchange", "gone is none and exchanges 1 > 0"));
}

TEST_F(Started, AgentsMayComeBeforeTheWorld) {
  start_busy();
  ASSERT_TRUE(does("start robot 4"));
  ASSERT_TRUE(does("start robot 1-3"));
  ASSERT_TRUE(happens("an agent waits", "log robot 4 has \"waiting for the world\""));
  ASSERT_TRUE(does("start radio"));
  ASSERT_TRUE(does("start world"));
  EXPECT_TRUE(happens("it starts", "step > 50 and members is 4 and disturbed is no"));
}

TEST_F(Started, AgentsMayComeOneByOneAndTheWorldSaysWhoIsMissing) {
  start_busy();
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(happens("nobody is there", "missing has \"robot 1\" and missing has \"robot 4\""));
  ASSERT_TRUE(does("start radio"));
  for (const std::string robot : {"1", "2", "3"}) {
    ASSERT_TRUE(does("start robot " + robot));
    ASSERT_TRUE(happens("one more", "state is waiting and missing lacks \"robot " + robot + "\""));
  }
  ASSERT_TRUE(does("start robot 4"));
  EXPECT_TRUE(happens("it starts", "step > 50 and members is 4 and disturbed is no"));
}

// Waiting robots send nothing but announcements.
TEST_F(Started, RobotsThatWaitForAnotherAreNotLost) {
  const std::chrono::duration<double> three_leases{3.0 * short_lease_s()};
  start_busy(kPatientStart);
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start radio"));
  ASSERT_TRUE(does("start robot 1-3"));
  ASSERT_TRUE(happens("one is missing",
                      "missing lacks \"robot 1\" and missing lacks \"robot 2\" and "
                      "missing lacks \"robot 3\" and missing has \"robot 4\""));
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(happens(
      "three leases are over",
      [&](const deploy::Seen&) { return std::chrono::steady_clock::now() - began > three_leases; },
      std::chrono::duration_cast<std::chrono::milliseconds>(2.0 * three_leases)));
  EXPECT_TRUE(happens("nobody was lost", "log world lacks \"robot lost\"", 1s));
}

TEST_F(Started, FifteenAgentsMayComeAtOnce) {
  deploy({.scenario = scenario("paper.toml"), .changes = kPatientStart, .lease_s = 60.0});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start radio"));
  ASSERT_TRUE(happens("nobody is there", "missing has \"robot 15\""));
  ASSERT_TRUE(does("start robots"));
  EXPECT_TRUE(happens("it starts", "step > 50 and members is 15 and disturbed is no"));
}

TEST_F(Started, FifteenAgentsMayComeOneByOne) {
  deploy({.scenario = scenario("paper.toml"), .changes = kPatientStart, .lease_s = 60.0});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(does("start radio"));
  for (int robot = 15; robot >= 1; --robot) {
    ASSERT_TRUE(does("start robot " + std::to_string(robot)));
    if (robot == 1) break;
    ASSERT_TRUE(happens("one more, and the others are waited for",
                        "missing lacks \"robot " + std::to_string(robot) +
                            "\" and missing has \"robot 1\" and state is waiting"));
  }
  EXPECT_TRUE(happens("it starts", "step > 50 and members is 15 and disturbed is no"));
}

TEST_F(Started, ARobotIsTakenOutOfTheWorldAndPutBackIn) {
  start_all_busy();
  ASSERT_TRUE(does("remove 3"));
  ASSERT_TRUE(happens("it is out", "removed has \"robot 3\" and members is 3 and gone is none"));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("pause"));
  ASSERT_TRUE(does("spawn 3 4.5 4.5"));
  ASSERT_TRUE(does("step"));
  EXPECT_TRUE(happens("its agent is awaited at once", "removed is none and members is 4"));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Started, ARobotIsSpawnedBeforeItHasAnAgent) {
  start_all_busy();
  ASSERT_TRUE(does("kill robot 3"));
  EXPECT_TRUE(happens("its loss is noticed", "gone has \"robot 3\""));
  ASSERT_TRUE(does("remove 3"));
  EXPECT_TRUE(happens("it is out", "removed has \"robot 3\" and gone is none"));
  ASSERT_TRUE(does("spawn 3 4.5 4.5"));
  ASSERT_TRUE(happens("it is missing", "missing has \"robot 3\" and removed is none and members is 3"));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("start robot 3"));
  EXPECT_TRUE(happens("its agent has come", "missing is none"));
  expect_back_and_working(3);
}

}  // namespace
}  // namespace caravan::test
