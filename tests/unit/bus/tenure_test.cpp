// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/tenure.hpp"

#include <gmock/gmock.h>

namespace caravan::runtime {
namespace {

using Standing = Tenure::Standing;

Sender participant(std::uint8_t number, Claim claim = Claim::kFull) {
  Sender sender;
  sender.prefix[0] = number;
  sender.claim = claim;
  return sender;
}

void run(const std::deque<Tenure::Later>& samples) {
  for (const Tenure::Later& later : samples) later();
}

TEST(Tenure, TheFirstThatClaimsHoldsAndOthersAreRefused) {
  Tenure tenure;

  EXPECT_EQ(tenure.claim(participant(1)), Standing::kBegins);
  EXPECT_EQ(tenure.claim(participant(1)), Standing::kHolds);
  EXPECT_EQ(tenure.claim(participant(2)), Standing::kRefused);
  EXPECT_EQ(tenure.holder(), participant(1));
}

TEST(Tenure, WhoMayClaimNothingNeverHolds) {
  Tenure tenure;

  EXPECT_EQ(tenure.claim(participant(1, Claim::kNone)), Standing::kRefused);
  EXPECT_FALSE(tenure.holder());
}

TEST(Tenure, AWeakHolderGivesWayToAFullClaimButNotToAnotherWeakOne) {
  Tenure tenure;
  (void)tenure.claim(participant(1, Claim::kWeak));

  EXPECT_EQ(tenure.claim(participant(2, Claim::kWeak)), Standing::kRefused);
  EXPECT_EQ(tenure.claim(participant(3)), Standing::kBegins);
  EXPECT_EQ(tenure.claim(participant(1, Claim::kWeak)), Standing::kRefused);
  EXPECT_EQ(tenure.claim(participant(4)), Standing::kRefused);
}

TEST(Tenure, IsFreeOnlyWhenTheHolderHasGone) {
  Tenure tenure;
  (void)tenure.claim(participant(1));

  EXPECT_FALSE(tenure.release(participant(2)));
  EXPECT_EQ(tenure.claim(participant(2)), Standing::kRefused);
  EXPECT_TRUE(tenure.release(participant(1)));
  EXPECT_EQ(tenure.claim(participant(2)), Standing::kBegins);
}

TEST(Tenure, GoesToTheFirstOfTheRefusedWithTheNewestThatItHasSent) {
  std::vector<int> seen;
  Tenure tenure;
  (void)tenure.claim(participant(1));
  tenure.keep(participant(2), [&] { seen.push_back(20); });
  tenure.keep(participant(3), [&] { seen.push_back(30); });
  tenure.keep(participant(2), [&] { seen.push_back(21); });

  (void)tenure.release(participant(1));
  run(tenure.hand_over());

  EXPECT_EQ(tenure.holder(), participant(2));
  EXPECT_THAT(seen, testing::ElementsAre(21));
}

TEST(Tenure, HandsOverAsManySamplesAsItKeepsInOrder) {
  std::vector<int> seen;
  Tenure tenure{2};
  (void)tenure.claim(participant(1));
  for (int i = 0; i < 3; ++i) tenure.keep(participant(2), [&seen, i] { seen.push_back(i); });

  (void)tenure.release(participant(1));
  run(tenure.hand_over());

  EXPECT_THAT(seen, testing::ElementsAre(1, 2));
}

TEST(Tenure, DoesNotGoToOneThatHasGoneItself) {
  Tenure tenure;
  (void)tenure.claim(participant(1));
  tenure.keep(participant(2), [] {});
  tenure.keep(participant(3), [] {});

  (void)tenure.release(participant(2));
  (void)tenure.release(participant(1));
  (void)tenure.hand_over();

  EXPECT_EQ(tenure.holder(), participant(3));
}

TEST(Tenure, GoesToAFullClaimBeforeAWeakOne) {
  Tenure tenure;
  (void)tenure.claim(participant(1));
  tenure.keep(participant(2, Claim::kWeak), [] {});
  tenure.keep(participant(3), [] {});

  (void)tenure.release(participant(1));
  (void)tenure.hand_over();

  EXPECT_EQ(tenure.holder(), participant(3));
}

TEST(Tenure, IsNotHandedOverWhileItIsHeld) {
  Tenure tenure;
  (void)tenure.claim(participant(1));
  tenure.keep(participant(2), [] {});

  EXPECT_TRUE(tenure.hand_over().empty());
  EXPECT_EQ(tenure.holder(), participant(1));
}

TEST(Tenure, KeepsTheSamplesOfAFewOnlyAndMakesRoomForAFullClaim) {
  Tenure tenure;
  (void)tenure.claim(participant(1));
  for (std::uint8_t number = 10; number < 200; ++number)
    tenure.keep(participant(number, Claim::kWeak), [] {});
  tenure.keep(participant(2), [] {});
  (void)tenure.release(participant(1));

  std::size_t handed_over = 0;
  for (; !tenure.hand_over().empty(); ++handed_over) (void)tenure.release(*tenure.holder());

  EXPECT_EQ(handed_over, 8U);
}

}  // namespace
}  // namespace caravan::runtime
