// SPDX-License-Identifier: Apache-2.0
// How often a bridge logs a notice, opens a line and tries a baud rate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/baud_search.hpp"
#include "hardware_bridge/core/host/notice_limit.hpp"
#include "hardware_bridge/core/host/retry.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Notice warning(const std::string& text) { return {Notice::Weight::kWarning, text}; }

TEST(NoticeLimit, TellsAFaultThatComesAndGoesThreeTimesThenOnceInThirtySecondsWithTheirNumber) {
  NoticeLimit limit;
  std::vector<std::string> told;
  for (Time now{0}; now < 90s; now += 1700ms) {
    if (const auto notice = limit.pass(warning("no robot answers on the line"), now))
      told.push_back(notice->text);
    for (const Notice& notice : limit.take_due(now)) told.push_back(notice.text);
  }
  ASSERT_THAT(told, SizeIs(5));
  EXPECT_EQ(told[2], "no robot answers on the line");
  EXPECT_THAT(told[3], HasSubstr("no robot answers on the line (1"));
  EXPECT_THAT(told[3], HasSubstr(" times in the last 30 s)"));
}

TEST(NoticeLimit, TheLastLineOfStatesIsTheOneThatHolds) {
  const Notice lost{Notice::Weight::kWarning, "position lost", "position"};
  const Notice known{Notice::Weight::kInfo, "position known", "position"};
  NoticeLimit limit;
  std::vector<std::string> told;
  const auto pass = [&](const Notice& notice, Time now) {
    if (const auto passed = limit.pass(notice, now)) told.push_back(passed->text);
  };
  for (int i = 0; i < 5; ++i) {
    pass(lost, 2s * i);
    pass(known, 2s * i + 1s);
  }
  for (Time now = 9s; now < 30s; now += 100ms) {
    for (const Notice& notice : limit.take_due(now)) {
      told.push_back(notice.text);
      EXPECT_EQ(now, 14s);
    }
  }
  EXPECT_THAT(told, ElementsAre("position lost", "position known", "position lost",
                                "position known (7 changes since the last line of it)"));
}

TEST(NoticeLimit, StatesThatChangeAllTheTimeAreToldEveryThirtySeconds) {
  NoticeLimit limit;
  std::size_t told = 0;
  for (Time now{0}; now < 91s; now += 1s) {
    told += limit.pass({Notice::Weight::kInfo, now / 1s % 2 == 0 ? "on" : "off", "motors"}, now) ? 1 : 0;
    told += limit.take_due(now).size();
  }
  EXPECT_LE(told, 6U);
}

TEST(NoticeLimit, NumbersMakeNoOtherKindAndOtherWordsDo) {
  NoticeLimit limit;
  int passed = 0;
  for (int metres = 0; metres < 10; ++metres) {
    passed += limit.pass(warning("fix " + std::to_string(metres) + ".5 m off"), 0s) ? 1 : 0;
  }
  EXPECT_EQ(passed, 3);
  EXPECT_TRUE(limit.pass(warning("battery low"), 0s));
}

TEST(NoticeLimit, AKindThatWasQuietBeginsAnew) {
  NoticeLimit limit;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(limit.pass(warning("cut"), 0s));
  EXPECT_FALSE(limit.pass(warning("cut"), 1s));
  EXPECT_THAT(limit.take_due(31s), SizeIs(1));
  EXPECT_THAT(limit.take_due(62s), IsEmpty());
  EXPECT_TRUE(limit.pass(warning("cut"), 62s));
}

TEST(NoticeLimit, StaysSmallWhateverADeviceCallsItself) {
  NoticeLimit limit;
  int passed = 0;
  for (int i = 0; i < 10000; ++i) {
    std::string name;
    for (int rest = i; rest > 0; rest /= 26) name += static_cast<char>('a' + rest % 26);
    passed += limit.pass(warning("robot connected: " + name), 0s) ? 1 : 0;
  }
  EXPECT_LT(passed, 300);
}

TEST(NoticeLimit, ADevicesNameDoesNotWriteLinesOfItsOwn) {
  NoticeLimit limit;
  EXPECT_EQ(limit.pass(warning("robot connected: x\n2026 error\x1b[31m"), 0s)->text,
            "robot connected: x?2026 error?[31m");
}

std::vector<unsigned> rates_tried(BaudSearch& search, int attempts) {
  std::vector<unsigned> rates;
  for (int i = 0; i < attempts; ++i) {
    rates.push_back(search.rate());
    search.next();
  }
  return rates;
}

TEST(BaudSearch, GoesRoundUntilARobotAnswers) {
  BaudSearch search;
  EXPECT_THAT(rates_tried(search, 6), ElementsAre(9600, 38400, 19200, 115200, 57600, 9600));
}

TEST(BaudSearch, TriesTheRateAtWhichTheRobotAnsweredFirstAndThenEverySecondTime) {
  BaudSearch search;
  search.next();
  search.next();
  search.found();
  search.next();  // the connection is lost
  EXPECT_THAT(rates_tried(search, 7), ElementsAre(19200, 115200, 19200, 57600, 19200, 9600, 19200));
}

TEST(Retry, OpensALineAgainAfterHalfASecond) {
  Retry retry;
  EXPECT_EQ(retry.due(), 0s);
  retry.tries(1s);
  EXPECT_EQ(retry.due(), 1500ms);
  retry.up(2s);
  retry.down(60s, true);
  EXPECT_EQ(retry.due(), 60500ms);
}

TEST(Retry, WaitsLongerEachTimeTheOtherEndClosesAtOnceAndNotForever) {
  Retry retry;
  Time now{0};
  std::vector<Time> waits;
  for (int i = 0; i < 7; ++i) {
    retry.tries(now);
    retry.up(now + 10ms);
    retry.down(now + 20ms, true);
    waits.push_back(retry.due() - now - 20ms);
    now = retry.due();
  }
  EXPECT_THAT(waits, ElementsAre(500ms, 1s, 2s, 4s, 4s, 4s, 4s));
  EXPECT_EQ(retry.brief(), 7U);
  retry.tries(now);
  retry.up(now);
  retry.down(now + 6s, true);
  EXPECT_EQ(retry.due(), now + 6500ms) << "it had lived";
}

}  // namespace
}  // namespace caravan::bridge
