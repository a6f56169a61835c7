// SPDX-License-Identifier: Apache-2.0
// Processes that are alive but suspended for a while, or hung.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/system/support/faults.hpp"

namespace caravan::test {
namespace {

using Suspended = Faults;

TEST_F(Suspended, AnAgentSuspendedForFiveSecondsComesBack) {
  start_all_busy();
  suspend_at_rest("robot 2");
  EXPECT_TRUE(happens("it is missed", "gone has \"robot 2\" and members is 3"));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(stays_suspended_for(std::max(5.0, 2.0 * short_lease_s())));
  ASSERT_TRUE(does("continue robot 2"));
  EXPECT_TRUE(happens("it is back", "gone is none and members is 4"));
  EXPECT_TRUE(happens("it has restarted itself", "log robot 2 has \"restarting\""));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(happens("it exchanges", "exchanges 2 > " + std::to_string(seen().robots.at(2).exchanges)));
}

TEST_F(Suspended, ARadioSuspendedForLongerThanItsLeaseComesBack) {
  start_all_busy();
  suspend_at_rest("radio");
  EXPECT_TRUE(happens("it is missed", "gone has radio"));
  ASSERT_TRUE(stays_suspended_for(2.0 * short_lease_s()));
  ASSERT_TRUE(does("continue radio"));
  EXPECT_TRUE(happens("it is back", "gone is none and members is 4"));
  const deploy::Seen now = seen();
  for (const std::string robot : {"1", "2", "3", "4"}) {
    const std::uint32_t exchanges = now.robots.at(static_cast<std::uint32_t>(std::stoul(robot))).exchanges;
    EXPECT_TRUE(happens("everybody hears it", "exchanges " + robot + " > " + std::to_string(exchanges)));
  }
}

TEST_F(Suspended, AWorldSuspendedForLongerThanItsLeaseEndsAndSaysWhy) {
  start_all_busy();
  suspend_at_rest("world");
  ASSERT_TRUE(stays_suspended_for(2.0 * short_lease_s()));
  ASSERT_TRUE(does("continue world"));
  EXPECT_TRUE(happens("it ends", "process world is ended and exit world is 1"));
  EXPECT_TRUE(happens("its log tells", "log world has \"longer than the lease\""));
  EXPECT_TRUE(happens("the others say what they wait for",
                      "log radio has \"world_server is gone: waiting\" and log robot 1 has \"world_server is "
                      "gone: waiting\""));
  ASSERT_TRUE(does("start world"));
  EXPECT_TRUE(happens("another begins", "sessions is 2 and members is 4"));
  EXPECT_TRUE(goes_on());
}

TEST_F(Suspended, AWorldSuspendedForLessThanItsLeaseGoesOn) {
  start_all_busy("", 60.0);
  suspend_at_rest("world");
  ASSERT_TRUE(stays_suspended_for(3.0));
  ASSERT_TRUE(does("continue world"));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(goes_on());
  EXPECT_TRUE(happens("nobody is missed", "gone is none and members is 4"));
}

TEST_F(Suspended, AHungAgentIsNamedAndWaitedFor) {
  start_all_busy("experiment.on_hung = \"wait\"\n", 60.0);  // hung, not gone: the lease is a minute
  suspend_at_rest("robot 3");
  EXPECT_TRUE(happens("it is named", "hung has \"robot 3\" and gone is none"));
  const std::uint64_t step = seen().step;
  EXPECT_FALSE(happens("the world waits", "step > " + std::to_string(step), 1s));
  ASSERT_TRUE(does("continue robot 3"));
  EXPECT_TRUE(
      happens("it goes on with it", "hung is none and members is 4 and step > " + std::to_string(step)));
  EXPECT_TRUE(happens("the log tells", "log world has \"alive but not answering: robot 3\"", 0s));
}

TEST_F(Suspended, AHungAgentIsCoastedPastUntilItAnswersAgain) {
  start_all_busy("experiment.on_hung = \"coast\"\n", 60.0);
  suspend_at_rest("robot 3");
  EXPECT_TRUE(happens("it is named and left out", "hung has \"robot 3\" and members is 3"));
  EXPECT_TRUE(goes_on());
  ASSERT_TRUE(does("continue robot 3"));
  EXPECT_TRUE(happens("it is back", "hung is none and members is 4"));
  EXPECT_TRUE(goes_on());
}

}  // namespace
}  // namespace caravan::test
