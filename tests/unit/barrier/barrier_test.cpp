// SPDX-License-Identifier: Apache-2.0
#include "world_server/barrier/barrier.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace caravan::world {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Wall kStart{};

/// A started barrier with three robots and a radio; step 0 is open.
Barrier started(const BarrierConfig& config = {.robots = 3}) {
  Barrier barrier{config};
  for (std::uint32_t robot = 1; robot <= config.robots; ++robot) barrier.answer(robot);
  barrier.open(kStart);
  return barrier;
}

/// The same, one step later: the radio has joined, and no one has answered yet.
Barrier under_way(const BarrierConfig& config = {.robots = 3}) {
  Barrier barrier = started(config);
  barrier.answer_radio();
  barrier.open(kStart);
  return barrier;
}

TEST(Barrier, ListsWhoIsMissingBeforeTheFirstStep) {
  Barrier barrier{{.robots = 3}};
  barrier.answer(2);
  EXPECT_THAT(barrier.missing(), ElementsAre(1, 3));
}

TEST(Barrier, MissesAgainWhoLeavesBeforeTheFirstStep) {
  Barrier barrier{{.robots = 2}};
  barrier.answer(1);
  barrier.answer(2);
  barrier.lose(1, kStart);
  EXPECT_THAT(barrier.missing(), ElementsAre(1));
  EXPECT_FALSE(barrier.disturbed());
}

TEST(Barrier, CountsTheJoiningAnswersForTheFirstStep) {
  const Barrier barrier = started();
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2, 3));
  EXPECT_TRUE(barrier.commands_in());
}

TEST(Barrier, WaitsForEveryMemberAndTheRadio) {
  Barrier barrier = under_way();
  barrier.answer(1);
  barrier.answer(3);
  EXPECT_FALSE(barrier.commands_in());
  barrier.answer(2);
  EXPECT_TRUE(barrier.commands_in());
  EXPECT_FALSE(barrier.radio_in());
  barrier.answer_radio();
  EXPECT_TRUE(barrier.radio_in());
  EXPECT_FALSE(barrier.disturbed());
}

TEST(Barrier, DoesNotCountTheSameAnswerTwice) {
  Barrier barrier = under_way();
  barrier.answer(1);
  barrier.answer(1);
  barrier.answer(2);
  EXPECT_FALSE(barrier.commands_in());
}

TEST(Barrier, GoesOnWithoutAMemberThatIsGone) {
  Barrier barrier = under_way();
  barrier.answer(1);
  barrier.answer(2);
  EXPECT_TRUE(barrier.lose(3, kStart));
  EXPECT_TRUE(barrier.commands_in());
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2));
  EXPECT_THAT(barrier.gone(), ElementsAre(3));
  EXPECT_TRUE(barrier.disturbed());
}

TEST(Barrier, KeepsTheAnswersRightWhenAMemberThatAnsweredIsGone) {
  Barrier barrier = under_way();
  barrier.answer(3);
  barrier.lose(3, kStart);
  barrier.answer(1);
  EXPECT_FALSE(barrier.commands_in());
  barrier.answer(2);
  EXPECT_TRUE(barrier.commands_in());
}

TEST(Barrier, TakesARobotBackFromTheStepAfterItsAnswer) {
  Barrier barrier = under_way();
  barrier.lose(3, kStart);
  EXPECT_EQ(barrier.answer(3), Answer::kNextStep);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2));
  barrier.open(kStart);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2, 3));
  EXPECT_THAT(barrier.gone(), IsEmpty());
}

TEST(Barrier, TakesARobotBackThatAnswersTooLateForItsStep) {
  Barrier barrier = under_way();
  barrier.lose(2, kStart);
  barrier.open(kStart);
  barrier.answer_late(2);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 3));
  EXPECT_THAT(barrier.gone(), IsEmpty());
  barrier.open(kStart);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2, 3));
  barrier.answer(1);
  barrier.answer(3);
  EXPECT_FALSE(barrier.commands_in()) << "it is awaited again, so it catches up";
}

TEST(Barrier, WaitsAgainForARadioThatAnswersTooLateForItsStep) {
  Barrier barrier = under_way();
  barrier.lose_radio();
  barrier.answer_radio_late();
  EXPECT_TRUE(barrier.radio_in()) << "not in this step";
  barrier.open(kStart);
  EXPECT_FALSE(barrier.radio_in());
  EXPECT_THAT(barrier.gone(), IsEmpty());
  EXPECT_TRUE(barrier.disturbed());
}

TEST(Barrier, ALateAnswerOfAMemberCountsForNothing) {
  Barrier barrier = under_way();
  barrier.answer_late(2);
  barrier.answer(1);
  barrier.answer(3);
  EXPECT_FALSE(barrier.commands_in());
}

TEST(Barrier, HoldsAStepThatLostAllMembersUntilOneAnswers) {
  Barrier barrier = under_way({.robots = 2});
  barrier.lose(1, kStart);
  barrier.lose(2, kStart);
  EXPECT_FALSE(barrier.commands_in());
  EXPECT_EQ(barrier.answer(2), Answer::kRevives);
  EXPECT_TRUE(barrier.commands_in());
  EXPECT_THAT(barrier.members(), ElementsAre(2));
}

TEST(Barrier, DoesNotWaitForARobotThatWasRemoved) {
  Barrier barrier = under_way();
  barrier.remove(2, kStart);
  barrier.open(kStart);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 3));
  EXPECT_EQ(barrier.answer(2), Answer::kNextStep);
  barrier.answer_late(2);
  EXPECT_FALSE(barrier.lose(2, kStart));
  EXPECT_THAT(barrier.missing(), IsEmpty());
  EXPECT_THAT(barrier.gone(), IsEmpty());
  barrier.open(kStart);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 3)) << "whatever it answered";
}

TEST(Barrier, WaitsInTheNextStepForASpawnedRobotWhoseAgentIsThere) {
  Barrier barrier = under_way();
  barrier.remove(2, kStart);
  barrier.open(kStart);
  barrier.spawn(2, true);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 3));
  barrier.open(kStart);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2, 3));
  barrier.answer(1);
  barrier.answer(3);
  EXPECT_FALSE(barrier.commands_in());
}

TEST(Barrier, MissesASpawnedRobotUntilItsAgentAnswers) {
  for (const bool late : {false, true}) {
    SCOPED_TRACE(late);
    Barrier barrier = under_way();
    barrier.remove(2, kStart);
    barrier.spawn(2, false);
    barrier.open(kStart);
    EXPECT_THAT(barrier.missing(), ElementsAre(2));
    EXPECT_THAT(barrier.members(), ElementsAre(1, 3));
    late ? barrier.answer_late(2) : static_cast<void>(barrier.answer(2));
    barrier.open(kStart);
    EXPECT_THAT(barrier.members(), ElementsAre(1, 2, 3));
    EXPECT_THAT(barrier.missing(), IsEmpty());
  }
}

TEST(Barrier, StopsWaitingForARadioThatIsGone) {
  Barrier barrier = under_way();
  EXPECT_TRUE(barrier.lose_radio());
  EXPECT_TRUE(barrier.radio_in());
  EXPECT_THAT(barrier.gone(), ElementsAre(0));
}

TEST(Barrier, WaitsForARadioThatCameBack) {
  Barrier barrier = under_way();
  barrier.lose_radio();
  barrier.answer_radio();
  barrier.open(kStart);
  EXPECT_FALSE(barrier.radio_in());
}

TEST(Barrier, GivesARadioThatNeverCameTenSecondsInTheFirstStep) {
  Barrier barrier = started();
  EXPECT_FALSE(barrier.let_go(kStart + 9s));
  EXPECT_FALSE(barrier.radio_in());
  EXPECT_TRUE(barrier.let_go(kStart + 10s));
  EXPECT_TRUE(barrier.radio_in());
  barrier.open(kStart + 10s);
  EXPECT_TRUE(barrier.radio_in());
  EXPECT_TRUE(barrier.disturbed());
}

TEST(Barrier, NamesAsHungWhoIsSilentForTwoSeconds) {
  Barrier barrier = under_way();
  barrier.answer(1);
  EXPECT_THAT(barrier.hung(kStart + 1900ms), IsEmpty());
  EXPECT_THAT(barrier.hung(kStart + 2s), ElementsAre(2, 3));
  EXPECT_FALSE(barrier.let_go(kStart + 1h));
  EXPECT_FALSE(barrier.commands_in());
}

TEST(Barrier, NamesTheRadioAsHungOnceAllCommandsAreIn) {
  Barrier barrier = under_way({.robots = 1});
  EXPECT_THAT(barrier.hung(kStart + 3s), ElementsAre(1));
  barrier.answer(1);
  EXPECT_THAT(barrier.hung(kStart + 3s), ElementsAre(0));
}

TEST(Barrier, CoastsWithoutAHungMemberUntilItAnswersAgain) {
  Barrier barrier = under_way({.robots = 2, .waits_for_hung = false});
  barrier.answer(1);
  EXPECT_FALSE(barrier.let_go(kStart + 1s));
  EXPECT_TRUE(barrier.let_go(kStart + 2s));
  EXPECT_TRUE(barrier.commands_in());
  EXPECT_THAT(barrier.hung(kStart + 2s), ElementsAre(2));
  barrier.open(kStart + 2s);
  EXPECT_THAT(barrier.members(), ElementsAre(1));
  EXPECT_EQ(barrier.answer(2), Answer::kNextStep);
  barrier.open(kStart + 2s);
  EXPECT_THAT(barrier.members(), ElementsAre(1, 2));
  EXPECT_TRUE(barrier.disturbed());
}

TEST(Barrier, GivesTheRadioNewPatienceWhenAHungMemberIsLetGo) {
  Barrier barrier = under_way({.robots = 2, .waits_for_hung = false});
  barrier.answer(1);
  barrier.let_go(kStart + 2s);
  EXPECT_FALSE(barrier.let_go(kStart + 3s));
  EXPECT_FALSE(barrier.radio_in());
  EXPECT_TRUE(barrier.let_go(kStart + 4s));
  EXPECT_TRUE(barrier.radio_in());
}

}  // namespace
}  // namespace caravan::world
