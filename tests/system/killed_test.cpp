// SPDX-License-Identifier: Apache-2.0
// Processes that are killed and started again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/system/support/faults.hpp"

namespace caravan::test {
namespace {

using Killed = Faults;

TEST_F(Killed, SeveralKilledAtOnceAreMissedAndTakenBack) {
  start_all_busy();
  ASSERT_TRUE(does("kill robot 1,3,4"));
  EXPECT_TRUE(
      happens("all are missed", "gone has \"robot 1\" and gone has \"robot 3\" and gone has \"robot 4\""));
  EXPECT_TRUE(happens("one is left", "members is 1"));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("start robot 1,3,4"));
  EXPECT_TRUE(happens("all are back", "gone is none and members is 4"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Killed, ARunThatLostAllItsAgentsGoesOnWithNewOnes) {
  start_all_busy();
  ASSERT_TRUE(does("kill robots"));
  EXPECT_TRUE(happens("all are missed", "members is 0"));
  // The world is held after the step that lost all agents, so that its new member is seen.
  // The step that is seen may be older than that of the world.
  const auto pauses = [&] { return bool{does("pause at " + std::to_string(seen().step + 1))}; };
  ASSERT_TRUE(eventually(pauses, kPatience));
  ASSERT_TRUE(does("start robot 1"));
  ASSERT_TRUE(happens("the first to answer is told to be its member", "member 1 is yes and members is 1"));
  ASSERT_TRUE(happens("it is paused", "state is paused"));
  ASSERT_TRUE(does("resume"));
  ASSERT_TRUE(does("start robot 2-4"));
  EXPECT_TRUE(happens("all are back", "gone is none and members is 4"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Killed, AgentsThatAreReplacedAtOnceGoOn) {
  start_all_busy();
  ASSERT_TRUE(does("restart robots"));
  EXPECT_TRUE(happens("they begin anew", "gone is none and members is 4 and disturbed is yes"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Killed, AKilledWorldBeginsANewSessionWithTheSameAgents) {
  start_all_busy();
  EXPECT_TRUE(
      happens("everybody has a path",
              "mode 1 is transport and mode 2 is transport and mode 3 is transport and mode 4 is transport"));
  const std::uint64_t before = seen().step;
  ASSERT_TRUE(does("restart world"));
  EXPECT_TRUE(happens("a new session begins", "sessions is 2 and members is 4"));
  EXPECT_LT(seen().time_s, 0.032 * static_cast<double>(before)) << "it begins anew";
  EXPECT_TRUE(happens("it goes on", "step > 100"));
  for (const std::string robot : {"1", "2", "3", "4"}) {
    EXPECT_TRUE(happens("nobody was restarted", "process robot " + robot + " is running", 0s));
    const std::string log = deploy::read_whole_file(seen().processes.at("robot " + robot).log);
    const std::size_t first = log.find("starting from the initial state");
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(log.find("starting from the initial state", first + 1), std::string::npos) << log;
  }
  EXPECT_TRUE(happens("the run is whole", "disturbed is no"));
  EXPECT_TRUE(happens("the radio works", "exchanges 1 > 0 and exchanges 2 > 0"));
}

TEST_F(Killed, AKilledRadioIsMissedAndTakenBack) {
  start_all_busy();
  ASSERT_TRUE(happens("they exchange", "exchanges 1 > 0"));
  ASSERT_TRUE(does("kill radio"));
  EXPECT_TRUE(happens("it is missed", "gone has radio"));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(happens("nobody stands for ever", [](const deploy::Seen& now) {
    return std::none_of(now.robots.begin(), now.robots.end(),
                        [](const auto& one) { return one.second.activity == "exchanging"; });
  }));
  const std::uint32_t exchanges = seen().robots.at(1).exchanges;
  ASSERT_TRUE(does("start radio"));
  EXPECT_TRUE(happens("it is taken back", "gone is none"));
  EXPECT_TRUE(happens("they exchange again", "exchanges 1 > " + std::to_string(exchanges)));
}

}  // namespace
}  // namespace caravan::test
