// SPDX-License-Identifier: Apache-2.0
#include "world_server/barrier/lockstep.hpp"

#include <gtest/gtest.h>

namespace caravan::world {
namespace {

using namespace std::chrono_literals;

constexpr Wall kNow{};

/// Two robots and a radio that have all answered stamp 0.
Barrier all_here() {
  Barrier barrier{{.robots = 2}};
  barrier.answer(1);
  barrier.answer(2);
  barrier.answer_radio();
  return barrier;
}

TEST(Lockstep, WaitsUntilNoRobotIsMissing) {
  const Lockstep lockstep{false};
  Barrier barrier{{.robots = 2}};
  barrier.answer(1);
  EXPECT_EQ(lockstep.next(barrier), Move::kNone);
  barrier.answer(2);
  EXPECT_EQ(lockstep.next(barrier), Move::kStart);
}

TEST(Lockstep, MovesTheBodiesWhenAllCommandsAreInAndEndsTheStepWhenTheRadioHasAnswered) {
  Lockstep lockstep{false};
  Barrier barrier = all_here();
  lockstep.open(0s);
  barrier.open(kNow);
  EXPECT_EQ(lockstep.next(barrier), Move::kAdvance) << "the answers to stamp 0 are those of the first step";
  lockstep.advance();
  EXPECT_EQ(lockstep.next(barrier), Move::kNone) << "the radio has not answered this step";
  barrier.answer_radio();
  EXPECT_EQ(lockstep.next(barrier), Move::kClose);
  lockstep.close();
  EXPECT_EQ(lockstep.next(barrier), Move::kOpenOrFinish);

  lockstep.open(32ms);
  barrier.open(kNow);
  barrier.answer(1);
  EXPECT_EQ(lockstep.next(barrier), Move::kNone) << "robot 2 has not answered";
  barrier.answer(2);
  EXPECT_EQ(lockstep.next(barrier), Move::kAdvance);
}

TEST(Lockstep, LeavesTheEndOfAStepToTheClockWhenItFollowsOne) {
  Lockstep lockstep{true};
  const Barrier barrier = all_here();
  EXPECT_EQ(lockstep.next(barrier), Move::kStart);
  lockstep.open(0s);
  EXPECT_EQ(lockstep.next(barrier), Move::kNone);
}

TEST(Lockstep, HasNothingToDoOnceTheRunIsOver) {
  const Barrier barrier = all_here();
  Lockstep finished{false};
  finished.open(0s);
  finished.advance();
  finished.close();
  finished.finish(32ms);
  EXPECT_EQ(finished.next(barrier), Move::kNone);
  EXPECT_EQ(finished.stamp(), 32ms);
  EXPECT_TRUE(finished.is_over());
  Lockstep failed{false};
  failed.open(0s);
  failed.fail();
  EXPECT_EQ(failed.next(barrier), Move::kNone);
  EXPECT_TRUE(failed.is_over());
}

TEST(Lockstep, TakesOnlyAnswersToTheOpenStep) {
  Lockstep lockstep{false};
  lockstep.open(0s);
  lockstep.advance();
  lockstep.close();
  lockstep.open(32ms);
  EXPECT_TRUE(lockstep.is_current(32ms));
  EXPECT_FALSE(lockstep.is_current(0s));
  EXPECT_FALSE(lockstep.is_current(64ms));
  lockstep.advance();
  lockstep.close();
  lockstep.finish(64ms);
  EXPECT_FALSE(lockstep.is_current(64ms));
}

TEST(Lockstep, TakesAnswersThatAreNotTooOldWhenItFollowsTheClock) {
  Lockstep lockstep{true};
  lockstep.open(1s);
  EXPECT_TRUE(lockstep.is_current(400ms));
  EXPECT_FALSE(lockstep.is_current(399ms));
}

TEST(Lockstep, CountsAStepAsBegunFromItsOpeningOn) {
  Lockstep lockstep{false};
  EXPECT_EQ(lockstep.first_not_begun(0), 1u) << "the sensors of step 0 are out from the start";
  lockstep.open(0s);
  EXPECT_EQ(lockstep.first_not_begun(0), 1u);
  lockstep.advance();
  EXPECT_EQ(lockstep.first_not_begun(1), 1u);
  lockstep.close();
  EXPECT_EQ(lockstep.first_not_begun(1), 1u);
  lockstep.open(32ms);
  EXPECT_EQ(lockstep.first_not_begun(1), 2u);
}

}  // namespace
}  // namespace caravan::world
