// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/last_error.hpp"

#include <gtest/gtest.h>

namespace caravan::deploy {
namespace {

const std::string kStart = "2026-01-01T00:00:00.000 info robot_agent: session=1 robot=2: starting\n";
const std::string kFault = "controller mine, robot 2, step 33 (1.024 s): threw an exception: no such cell";

TEST(LastError, IsTheMessageOfTheLastLineOfAnError) {
  EXPECT_EQ(last_error_in(kStart + "2026-01-01T00:00:01.000 error robot_agent: first\n" +
                          "2026-01-01T00:00:02.000 error robot_agent: " + kFault + "\n" +
                          "2026-01-01T00:00:03.000 info robot_agent: bye: bye\n"),
            kFault);
  EXPECT_EQ(last_error_in("2026-01-01T00:00:02.000 critical robot_agent: " + kFault), kFault);
}

TEST(LastError, IsWhatACrashHandlerWrites) {
  const std::string crash = "controller mine, robot 2, step 33 (1.024 s): ends the process by SIGSEGV";
  EXPECT_EQ(last_error_in(kStart + crash + "\n"), crash);
}

TEST(LastError, IsMissingWhereThereIsNone) {
  EXPECT_EQ(last_error_in(""), "");
  EXPECT_EQ(last_error_in(kStart + "2026-01-01T00:00:01.000 warning robot_agent: controller mine: slow\n"),
            "");
  EXPECT_EQ(last_error_in("my error output: nothing\nerror\n\n"), "") << "of the controller itself";
  EXPECT_EQ(last_error_of("/nowhere/at/all.log"), "");
}

}  // namespace
}  // namespace caravan::deploy
