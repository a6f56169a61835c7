// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "world_server/control/control.hpp"

namespace caravan::world {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = Outcome::Kind;

/// The control of a world of four robots between its steps.
class WorldControl : public ::testing::Test {
 protected:
  std::optional<Outcome> ask(const Action& action, std::uint64_t at_step = 0, std::uint64_t next_step = 1) {
    return control_.ask({"me", ++id_, at_step, action}, next_step);
  }
  std::vector<Outcome> reach(std::uint64_t step) {
    return control_.reach(step, {.teleport =
                                     [this](const Teleport& teleport) {
                                       placed_.push_back(teleport);
                                       return refusal_;
                                     },
                                 .spawn =
                                     [this](const Spawn& spawn) {
                                       spawned_.push_back(spawn.robot);
                                       return refusal_;
                                     },
                                 .remove =
                                     [this](const Remove& remove) {
                                       removed_.push_back(remove.robot);
                                       return refusal_;
                                     }});
  }

  Control control_{{.robots = 4}};
  std::uint32_t id_ = 0;
  std::vector<Teleport> placed_;
  std::vector<std::uint32_t> spawned_;
  std::vector<std::uint32_t> removed_;
  std::string refusal_;
};

TEST_F(WorldControl, DoesNothingUnasked) {
  EXPECT_THAT(reach(1), IsEmpty());
  EXPECT_FALSE(control_.is_paused());
  EXPECT_FALSE(control_.was_used());
}

TEST_F(WorldControl, PausesAtTheStepAskedForAndNotBefore) {
  EXPECT_EQ(ask(Pause{}, 10)->kind, Kind::kScheduled);
  EXPECT_THAT(reach(9), IsEmpty());
  EXPECT_FALSE(control_.is_paused());
  EXPECT_FALSE(control_.was_used());
  EXPECT_THAT(reach(10), ::testing::ElementsAre(Outcome{"me", 1, Kind::kDone, 10, ""}));
  EXPECT_TRUE(control_.is_paused());
  EXPECT_TRUE(control_.was_used());
}

TEST_F(WorldControl, WithoutAStepTheNextOneCounts) {
  EXPECT_EQ(ask(Pause{}, 0, 57)->step, 57U);
  EXPECT_THAT(reach(56), IsEmpty());
  EXPECT_EQ(reach(57).size(), 1U);
}

TEST_F(WorldControl, RefusesAStepThatHasBegun) {
  const auto outcome = ask(Pause{}, 5, 57);
  EXPECT_EQ(outcome->kind, Kind::kRefused);
  EXPECT_EQ(outcome->reason, "step 5 has begun, the next is 57");
}

TEST_F(WorldControl, TakesSoManyStepsAndIsPausedAgain) {
  (void)ask(Pause{}, 3);
  (void)reach(3);
  (void)ask(TakeSteps{2}, 0, 3);
  EXPECT_EQ(reach(3)[0].kind, Kind::kDone);
  EXPECT_FALSE(control_.is_paused());
  (void)reach(4);
  EXPECT_FALSE(control_.is_paused());
  (void)reach(5);
  EXPECT_TRUE(control_.is_paused());
  (void)ask(Resume{}, 0, 5);
  (void)reach(5);
  (void)reach(6);
  EXPECT_FALSE(control_.is_paused());
}

TEST_F(WorldControl, TakesNoCountedStepsWhileItRuns) {
  (void)ask(TakeSteps{2});
  const auto outcomes = reach(1);
  EXPECT_EQ(outcomes[0].kind, Kind::kRefused);
  EXPECT_EQ(outcomes[0].reason, "the world is running: pause it first");
  EXPECT_FALSE(control_.was_used()) << "what was refused disturbs nothing";
}

TEST_F(WorldControl, ObeysOrdersOfOneStepAsTheyCame) {
  (void)ask(Teleport{1, {1.0, 0.0, 0.0}}, 8);
  (void)ask(Teleport{2, {2.0, 0.0, 0.0}}, 7);
  (void)ask(Teleport{3, {3.0, 0.0, 0.0}}, 8);
  (void)reach(7);
  (void)reach(8);
  ASSERT_EQ(placed_.size(), 3U);
  EXPECT_EQ(placed_[0].robot, 2U);
  EXPECT_EQ(placed_[1].robot, 1U);
  EXPECT_EQ(placed_[2].robot, 3U);
}

TEST_F(WorldControl, SaysWhatKeptATeleportBack) {
  refusal_ = "robot 2 is there";
  (void)ask(Teleport{1, {}});
  const auto outcomes = reach(1);
  EXPECT_EQ(outcomes[0].kind, Kind::kRefused);
  EXPECT_EQ(outcomes[0].reason, "robot 2 is there");
  EXPECT_FALSE(control_.was_used());
}

TEST_F(WorldControl, HoldsARobotUntilItIsReleased) {
  (void)ask(Hold{2});
  (void)reach(1);
  EXPECT_TRUE(control_.is_held(2));
  EXPECT_FALSE(control_.is_held(1));
  (void)ask(Release{2}, 0, 2);
  (void)reach(2);
  EXPECT_FALSE(control_.is_held(2));
}

TEST_F(WorldControl, RemovesAndSpawnsAtTheirSteps) {
  (void)ask(Spawn{2, {1.0, 0.0, 0.0}}, 9);
  (void)ask(Remove{2}, 4);
  (void)reach(4);
  EXPECT_THAT(removed_, ::testing::ElementsAre(2));
  EXPECT_THAT(spawned_, IsEmpty());
  (void)reach(9);
  EXPECT_THAT(spawned_, ::testing::ElementsAre(2));
}

TEST_F(WorldControl, NoLongerHoldsARobotThatIsRemoved) {
  (void)ask(Hold{2});
  (void)ask(Hold{3});
  (void)ask(Remove{2});
  (void)reach(1);
  EXPECT_FALSE(control_.is_held(2));
  refusal_ = "it stays";
  (void)ask(Remove{3}, 0, 2);
  EXPECT_EQ(reach(2)[0].reason, "it stays");
  EXPECT_TRUE(control_.is_held(3));
}

TEST_F(WorldControl, ChangesTheSpeed) {
  EXPECT_EQ(control_.speed(), 0.0);
  (void)ask(SetSpeed{2.5});
  (void)reach(1);
  EXPECT_EQ(control_.speed(), 2.5);
}

TEST_F(WorldControl, RefusesWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Action, std::string>> cases{
      {Hold{0}, "no robot 0"},
      {Release{5}, "no robot 5"},
      {Teleport{9, {}}, "no robot 9"},
      {Teleport{1, {nan, 0.0, 0.0}}, "finite"},
      {TakeSteps{0}, "at least 1"},
      {SetSpeed{-1.0}, "0.001 to 1000"},
      {SetSpeed{nan}, "0.001 to 1000"},
      {Spawn{5, {}}, "no robot 5, only 1 to 4"},
      {Spawn{1, {nan, 0.0, 0.0}}, "finite"},
      {Remove{5}, "no robot 5"},
      {UnknownAction{}, "unknown"},
  };
  for (const auto& [action, reason] : cases) {
    SCOPED_TRACE(reason);
    const auto outcome = ask(action);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->kind, Kind::kRefused);
    EXPECT_THAT(outcome->reason, HasSubstr(reason));
  }
  EXPECT_THAT(reach(1), IsEmpty());
}

TEST_F(WorldControl, RefusesASpeedWhereTheClockSetsIt) {
  Control free{{.robots = 4, .speed = 1.0, .follows_clock = true}};
  EXPECT_EQ(free.ask({"me", 1, 0, SetSpeed{2.0}}, 1)->reason, "pacing free follows the clock");
}

TEST_F(WorldControl, TakesARepeatedOrderOnce) {
  (void)control_.ask({"me", 7, 0, Teleport{1, {}}}, 1);
  EXPECT_EQ(control_.ask({"me", 7, 0, Teleport{1, {}}}, 1), std::nullopt);
  EXPECT_EQ(control_.ask({"me", 6, 0, Teleport{1, {}}}, 1), std::nullopt);
  EXPECT_TRUE(control_.ask({"you", 7, 0, Teleport{1, {}}}, 1)) << "another requester counts by itself";
  (void)reach(1);
  EXPECT_EQ(placed_.size(), 2U);
}

TEST_F(WorldControl, AnswersEverybodyWhenTheRunEnds) {
  (void)ask(Pause{}, 100);
  const auto outcomes = control_.end();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].kind, Kind::kRefused);
  EXPECT_EQ(outcomes[0].reason, "the run ended before step 100");
  EXPECT_EQ(ask(Pause{})->reason, "the run has ended");
}

}  // namespace
}  // namespace caravan::world
