// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/standstill.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace caravan::deploy {
namespace {

using namespace std::chrono_literals;
using caravan_interfaces::msg::WorldStatus;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Optional;

const runtime::WallTime kBegan{1000s};

TEST(Standstill, SaysNothingWhileStepsCome) {
  Standstill run{kBegan};
  for (auto now = kBegan; now < kBegan + 30s; now += 1s) {
    run.note_step(now);
    run.note_world(now);
    EXPECT_EQ(run.say(now, WorldStatus{}), std::nullopt);
  }
}

TEST(Standstill, SaysEveryFiveSecondsWhatItWaitsFor) {
  Standstill run{kBegan};
  int lines = 0;
  WorldStatus world;
  world.hung({"robot 3", "radio"});
  for (auto now = kBegan; now <= kBegan + 21s; now += 250ms) {
    run.note_world(now);
    const auto line = run.say(now, world);
    if (!line) continue;
    ++lines;
    EXPECT_THAT(*line, HasSubstr("robot 3, radio does not answer"));
  }
  EXPECT_EQ(lines, 4);
  EXPECT_EQ(run.give_up(kBegan + 21s, world), std::nullopt) << "the world speaks: as long as it takes";
}

TEST(Standstill, NamesRobotsThatAreGoneWhenNoneIsLeft) {
  WorldStatus world;
  world.gone({"robot 1", "robot 2"});
  Standstill run{kBegan};
  run.note_world(kBegan + 6s);
  EXPECT_THAT(run.say(kBegan + 6s, world), Optional(HasSubstr("robot 1, robot 2 is gone")));
  world.members(1);
  run.note_world(kBegan + 12s);
  EXPECT_THAT(run.say(kBegan + 12s, world), Optional(Not(HasSubstr("is gone")))) << "the third one goes on";
}

TEST(Standstill, TellsWhatHoldsTheWorldInItsOwnWords) {
  WorldStatus world;
  world.members(2);
  world.held("observer viewer is alive but handles no more steps");
  Standstill run{kBegan};
  run.note_world(kBegan + 6s);
  EXPECT_EQ(run.say(kBegan + 6s, world),
            "no step for 6 s: observer viewer is alive but handles no more steps");
}

TEST(Standstill, TellsAPauseFromARobotThatIsMissing) {
  WorldStatus world;
  world.missing({"robot 2"});
  Standstill starting{kBegan};
  starting.note_world(kBegan + 6s);
  EXPECT_THAT(starting.say(kBegan + 6s, world), Optional(HasSubstr("robot 2 is missing")));
  world.paused(true);
  Standstill paused{kBegan};
  paused.note_world(kBegan + 6s);
  EXPECT_THAT(paused.say(kBegan + 6s, world), Optional(HasSubstr("caravan ctl resume")));
}

TEST(Standstill, GivesASilentWorldUpAfterAMinute) {
  Standstill run{kBegan};
  run.note_world(kBegan);
  EXPECT_THAT(run.say(kBegan + 10s, WorldStatus{}), Optional(HasSubstr("has been silent for 10 s")));
  EXPECT_EQ(run.give_up(kBegan + 59s, WorldStatus{}), std::nullopt);
  EXPECT_THAT(run.give_up(kBegan + 60s, WorldStatus{}), Optional(HasSubstr("is given up")));
  EXPECT_EQ(run.give_up(kBegan + 600s, std::nullopt), std::nullopt) << "its start has another deadline";
}

TEST(Standstill, GivesARunInWhichNoRobotIsLeftUpAfterAMinute) {
  WorldStatus world;
  world.gone({"robot 1", "robot 2"});
  const auto at = [&](std::chrono::seconds after) {
    Standstill run{kBegan};
    run.note_world(kBegan + after);
    return run.give_up(kBegan + after, world);
  };
  EXPECT_EQ(at(59s), std::nullopt) << "others may take their place";
  EXPECT_THAT(at(60s), Optional(HasSubstr("robot 1, robot 2 is gone, and no robot has been left for 60 s")));
  world.paused(true);
  EXPECT_EQ(at(600s), std::nullopt) << "somebody has paused it";
  world.paused(false);
  world.members(1);
  EXPECT_EQ(at(600s), std::nullopt) << "one is left: it is waited for";
  world.members(0);
  world.gone({});
  world.missing({"robot 1"});
  EXPECT_EQ(at(600s), std::nullopt) << "its start has another deadline";
}

}  // namespace
}  // namespace caravan::deploy
