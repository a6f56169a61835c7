// SPDX-License-Identifier: Apache-2.0
#include "tests/support/patience.hpp"

#include <gtest/gtest.h>

namespace caravan::test {
namespace {

using namespace std::chrono_literals;

TEST(Slowness, IsOneOnAnIdleMachineAndOnAFasterOne) {
  EXPECT_EQ(slowness(0, 4, 1.0), 1.0);
  EXPECT_EQ(slowness(3, 4, 1.0), 1.0) << "a processor for everybody";
  EXPECT_EQ(slowness(0, 4, 0.5), 1.0);
}

TEST(Slowness, GrowsWithWhatElseIsReadyToRunAndWithASlowProcessor) {
  EXPECT_EQ(slowness(11, 2, 1.0), 6.0) << "twelve share two processors";
  EXPECT_EQ(slowness(0, 4, 10.0), 10.0);
  EXPECT_EQ(slowness(11, 2, 10.0), 60.0);
  EXPECT_GE(slowness(), 1.0);
}

TEST(Patience, IsOverAfterItsTimeOnAnIdleMachine) {
  Patience patience{10s};
  for (int second = 0; second < 8; ++second) patience.count(1s, 1.0);
  EXPECT_FALSE(patience.is_over());
  for (int second = 8; second < 10; ++second) patience.count(1s, 1.0);
  EXPECT_TRUE(patience.is_over());
}

TEST(Patience, LastsLongerByAsMuchAsTheMachineIsSlower) {
  Patience patience{2s};
  for (int second = 0; second < 9; ++second) patience.count(1s, 10.0);
  EXPECT_FALSE(patience.is_over());
  for (int second = 9; second < 20; ++second) patience.count(1s, 10.0);
  EXPECT_TRUE(patience.is_over());
}

TEST(Patience, CountsNoMoreThanASecondOfAPauseOfTheWholeMachine) {
  Patience patience{3s};
  patience.count(10min, 1.0);
  EXPECT_NEAR(patience.left().count(), 2.0, 1e-9);
}

TEST(Eventually, LooksOnceMoreWhenItsTimeIsOver) {
  int looks = 0;
  EXPECT_TRUE(eventually([&] { return ++looks == 2; }, 0ms));
  EXPECT_FALSE(eventually([] { return false; }, 0ms));
}

}  // namespace
}  // namespace caravan::test
