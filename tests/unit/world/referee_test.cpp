// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "runtime/pure/random.hpp"
#include "world_server/referee/contact_episodes.hpp"
#include "world_server/referee/items.hpp"
#include "world_server/referee/sanitise.hpp"

namespace caravan::world {
namespace {

constexpr Pose kSource{0.0, 0.0, 0.0};
constexpr Pose kDestination{10.0, 0.0, 0.0};
constexpr Pose kElsewhere{5.0, 0.0, 0.0};

ItemRules rules(std::uint32_t items) {
  return {.source = {0.0, 0.0}, .destination = {10.0, 0.0}, .service_radius_m = 1.5, .items = items};
}

TEST(Items, AGripperThatClosesAtTheSourceTakesOne) {
  Items items{rules(2), 1};
  const auto event = items.grip(1, kSource, true);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->kind, ItemEvent::Kind::kPickUp);
  EXPECT_EQ(event->robot, 1U);
  EXPECT_TRUE(items.holds(1));
  EXPECT_EQ(items.stock(), 2U);
}

TEST(Items, TheServiceRadiusIsPartOfTheSite) {
  Items items{rules(2), 2};
  EXPECT_TRUE(items.grip(1, {1.5, 0.0, 0.0}, true));
  EXPECT_FALSE(items.grip(2, {1.5001, 0.0, 0.0}, true));
}

TEST(Items, AGripperThatStaysClosedIntoTheSourceTakesNothing) {
  Items items{rules(2), 1};
  EXPECT_FALSE(items.grip(1, kElsewhere, true));
  EXPECT_FALSE(items.grip(1, kSource, true));
  EXPECT_FALSE(items.holds(1));
  EXPECT_EQ(items.empty_closings(), 1U);
}

TEST(Items, AGripperThatOpensAtTheDestinationDelivers) {
  Items items{rules(1), 1};
  static_cast<void>(items.grip(1, kSource, true));
  EXPECT_FALSE(items.grip(1, kDestination, true));
  EXPECT_FALSE(items.all_delivered());
  const auto event = items.grip(1, kDestination, false);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->kind, ItemEvent::Kind::kDelivery);
  EXPECT_TRUE(items.all_delivered());
  EXPECT_FALSE(items.grip(1, kDestination, false));
  EXPECT_EQ(items.delivered(), 1U);
}

TEST(Items, OneDroppedElsewhereGoesBackToTheStock) {
  Items items{rules(1), 1};
  static_cast<void>(items.grip(1, kSource, true));
  EXPECT_EQ(items.stock(), 1U);
  EXPECT_FALSE(items.grip(1, kElsewhere, false));
  EXPECT_EQ(items.stock(), 2U);
  EXPECT_TRUE(items.grip(1, kSource, true));
}

TEST(Items, AnEmptySourceGivesNothingAndCountsTheClosing) {
  Items items{rules(1), 2};
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(items.grip(1, kSource, true));
    EXPECT_TRUE(items.grip(1, kDestination, false));
  }
  EXPECT_FALSE(items.grip(2, kSource, true));
  EXPECT_EQ(items.empty_closings(), 1U);
}

TEST(Items, ARobotLostWithAnItemDoesNotKeepTheOthersFromFinishing) {
  Items items{rules(1), 2};
  EXPECT_TRUE(items.grip(1, kSource, true));
  EXPECT_TRUE(items.grip(2, kSource, true));
  EXPECT_TRUE(items.grip(2, kDestination, false));
  EXPECT_TRUE(items.all_delivered());
}

TEST(Items, WithoutANumberTheSourceNeverEndsAndNothingIsFinished) {
  Items items{rules(0), 1};
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(items.grip(1, kSource, true));
    EXPECT_TRUE(items.grip(1, kDestination, false));
  }
  EXPECT_EQ(items.delivered(), 10U);
  EXPECT_FALSE(items.all_delivered());
}

TEST(Items, NoneIsEverLostOrMade) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    Items items{rules(5), 4};
    for (int i = 0; i < 500; ++i) {
      const auto robot = static_cast<std::uint32_t>(random.uniform(1.0, 5.0));
      static_cast<void>(items.grip(robot, {random.uniform(-3.0, 13.0), 0.0, 0.0}, random.chance(0.5)));
      std::uint32_t held = 0;
      for (std::uint32_t one = 1; one <= 4; ++one) held += items.holds(one) ? 1U : 0U;
      ASSERT_EQ(items.stock() + held + items.delivered(), 9U) << "5 to deliver and one for each of 4 robots";
    }
  }
}

constexpr ContactEpisode kPair{1, 2};
constexpr ContactEpisode kWall{1, 0};

TEST(ContactEpisodes, OneLastsUntilThePairHasBeenApartForASecond) {
  ContactEpisodes episodes;
  const std::vector<ContactEpisode> touching{kPair};
  std::size_t begun = 0;
  const auto touch_at = [&](int ms) {
    begun += episodes.begun(std::chrono::milliseconds{ms}, touching).size();
  };
  touch_at(0);
  touch_at(32);
  touch_at(1000);
  touch_at(1999);
  EXPECT_EQ(begun, 1U);
  touch_at(2999);
  EXPECT_EQ(begun, 2U);
}

TEST(ContactEpisodes, PairsAreCountedApart) {
  ContactEpisodes episodes;
  EXPECT_EQ(episodes.begun(Time{0}, std::vector{kPair}).size(), 1U);
  const auto begun = episodes.begun(std::chrono::milliseconds{32}, std::vector{kPair, kWall});
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(begun[0].other, 0U);
}

TEST(Sanitise, LeavesGoodCommandsAlone) {
  EXPECT_EQ(sanitise(1.6, -1.6, 1.6), (Sanitised{.left_mps = 1.6, .right_mps = -1.6}));
}

TEST(Sanitise, ClampsEachRimToTheLimit) {
  EXPECT_EQ(sanitise(2.0, -0.5, 1.6), (Sanitised{.left_mps = 1.6, .right_mps = -0.5, .clamped = true}));
  EXPECT_EQ(sanitise(0.0, -9e300, 1.6), (Sanitised{.left_mps = 0.0, .right_mps = -1.6, .clamped = true}));
}

TEST(Sanitise, StopsBothWheelsForWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    EXPECT_EQ(sanitise(bad, 1.0, 1.6), (Sanitised{.refused = true}));
    EXPECT_EQ(sanitise(1.0, bad, 1.6), (Sanitised{.refused = true}));
  }
}

}  // namespace
}  // namespace caravan::world
