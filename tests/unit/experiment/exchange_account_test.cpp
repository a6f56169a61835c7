// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/exchange_account.hpp"

#include <gmock/gmock.h>

namespace caravan::experiment {
namespace {

using std::chrono::seconds;

Exchange session(std::uint32_t partner, std::uint32_t number, bool completed, Time began, Time ended) {
  return {.partner = partner, .session = number, .completed = completed, .began = began, .ended = ended};
}

TEST(ExchangeAccount, CountsTheTwoReportsOfASessionOnce) {
  ExchangeAccount account;
  account.add(7, session(3, 12, true, seconds{100}, seconds{102}));
  account.add(3, session(7, 12, true, seconds{100}, seconds{103}));

  EXPECT_EQ(account.completed(), 1U);
  EXPECT_EQ(account.failed(), 0U);
}

TEST(ExchangeAccount, ASessionIsCompletedWhenEitherSideCompletedItInWhateverOrderTheyTell) {
  ExchangeAccount account;
  account.add(7, session(3, 12, false, seconds{100}, seconds{110}));
  EXPECT_EQ(account.failed(), 1U);
  account.add(3, session(7, 12, true, seconds{100}, seconds{103}));
  account.add(2, session(1, 5, true, seconds{100}, seconds{103}));
  account.add(1, session(2, 5, false, seconds{100}, seconds{103}));

  EXPECT_EQ(account.completed(), 2U);
  EXPECT_EQ(account.failed(), 0U);
}

TEST(ExchangeAccount, EachRobotThatGaveUpBeforeANumberWasKnownCounts) {
  ExchangeAccount account;
  account.add(7, session(3, 0, false, seconds{100}, seconds{108}));
  account.add(3, session(7, 0, false, seconds{100}, seconds{110}));

  EXPECT_EQ(account.failed(), 2U);
}

TEST(ExchangeAccount, DifferentPairsAndDifferentNumbersAreDifferentSessions) {
  ExchangeAccount account;
  account.add(7, session(3, 12, true, seconds{100}, seconds{102}));
  account.add(7, session(4, 12, true, seconds{110}, seconds{112}));
  account.add(7, session(3, 13, true, seconds{120}, seconds{122}));

  EXPECT_EQ(account.completed(), 3U);
}

TEST(ExchangeAccount, ANumberUsedAgainMuchLaterIsAnotherSession) {
  ExchangeAccount account;
  account.add(7, session(3, 1, true, seconds{1000}, seconds{1002}));
  account.add(3, session(7, 1, true, seconds{1700}, seconds{1702}));

  EXPECT_EQ(account.completed(), 2U);
}

TEST(ExchangeAccount, MeanDurationIsOverAllReportsWithFailedAttempts) {
  ExchangeAccount account;
  EXPECT_EQ(account.mean_duration_s(), 0.0);
  account.add(7, session(3, 12, true, seconds{100}, seconds{102}));
  account.add(3, session(7, 12, true, seconds{100}, seconds{104}));
  account.add(9, session(7, 0, false, seconds{100}, seconds{112}));

  EXPECT_DOUBLE_EQ(account.mean_duration_s(), 6.0);
}

TEST(ExchangeAccount, ManyLongExchangesDoNotOverflow) {
  ExchangeAccount account;
  for (std::uint32_t number = 0; number < 20; ++number)
    account.add(7, session(3, number, true, seconds{0}, seconds{1'000'000'000}));

  EXPECT_EQ(account.mean_duration_s(), 1e9);
}

}  // namespace
}  // namespace caravan::experiment
