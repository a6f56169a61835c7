// SPDX-License-Identifier: Apache-2.0
#include "world_server/shell/credits.hpp"

#include <gmock/gmock.h>

namespace caravan::world {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

runtime::Sender observer(std::uint8_t number) {
  runtime::Sender sender;
  sender.prefix[0] = number;
  sender.claim = runtime::Claim::kFull;
  return sender;
}

TEST(Credits, HoldTheWorldBackUntilTheirObserverHasHandledEnough) {
  Credits credits{{}};
  EXPECT_TRUE(credits.give("launcher", observer(1), 1s));
  EXPECT_EQ(credits.holding_back(10s, 8s), "launcher");
  EXPECT_TRUE(credits.give("launcher", observer(1), 5s));
  EXPECT_EQ(credits.holding_back(10s, 8s), std::nullopt);
}

TEST(Credits, OfAnotherParticipantUnderTheSameNameAreRefusedUntilTheFirstHasGone) {
  Credits credits{{"launcher"}};
  EXPECT_TRUE(credits.give("launcher", observer(1), 5s));
  EXPECT_FALSE(credits.give("launcher", observer(2), 0s));
  EXPECT_EQ(credits.holding_back(10s, 8s), std::nullopt) << "the forged one does not count";
  credits.lose(observer(1));
  EXPECT_EQ(credits.holding_back(10s, 8s), "launcher") << "what the second has said counts now";
  EXPECT_THAT(credits.missing(), IsEmpty());
}

TEST(Credits, AreMissingOfAnAwaitedObserverThatHasGone) {
  Credits credits{{"kit"}};
  EXPECT_THAT(credits.missing(), ElementsAre("kit"));
  (void)credits.give("kit", observer(1), 0s);
  EXPECT_THAT(credits.missing(), IsEmpty());
  credits.lose(observer(1));
  EXPECT_THAT(credits.missing(), ElementsAre("kit"));
}

TEST(Credits, OfObserversThatAreNotAwaitedAreBoundedAndMayBeLetGo) {
  Credits credits{{"kit"}};
  for (int i = 0; i < 64; ++i) EXPECT_TRUE(credits.give("observer " + std::to_string(i), observer(1), 0s));
  EXPECT_FALSE(credits.give("one more", observer(1), 0s));
  EXPECT_TRUE(credits.give("kit", observer(2), 0s));
  while (const auto name = credits.holding_back(10s, 8s)) credits.let_go(*name);
  EXPECT_EQ(credits.holding_back(10s, 8s), std::nullopt);
}

}  // namespace
}  // namespace caravan::world
