// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/activity_account.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace caravan::experiment {
namespace {

using std::chrono::seconds;

constexpr Time kStep = std::chrono::milliseconds{32};

/// The account of `length` in steps of 32 ms, with place and activity as functions of time.
ActivityTimes account_for(
    Time length, const std::function<Place(double)>& place, const std::function<Activity(double)>& activity,
    const std::function<bool(double)>& present = [](double) { return true; }) {
  ActivityAccount account;
  for (Time now{0}; now < length; now += kStep) {
    const double now_s = in_seconds(now);
    account.add(now, kStep, place(now_s), activity(now_s), present(now_s));
  }
  return account.times();
}

Place standing(double) { return {3.0, 4.0}; }
Place driving_east(double now_s) { return {0.5 * now_s, 0.0}; }
Activity always_driving(double) { return Activity::kDriving; }

Time sum(const ActivityTimes& times) {
  return times.driving + times.exchanging + times.avoiding + times.stuck + times.idle;
}

TEST(ActivityAccount, BooksTimeAsWhatTheRobotSaysItDoes) {
  const ActivityTimes times = account_for(seconds{320}, driving_east, [](double now_s) {
    if (now_s < 32.0) return Activity::kIdle;
    if (now_s < 96.0) return Activity::kAvoiding;
    return now_s < 128.0 ? Activity::kExchanging : Activity::kDriving;
  });

  EXPECT_EQ(times.idle, seconds{32});
  EXPECT_EQ(times.avoiding, seconds{64});
  EXPECT_EQ(times.exchanging, seconds{32});
  EXPECT_EQ(times.driving, seconds{192});
  EXPECT_EQ(times.stuck, seconds{0});
}

TEST(ActivityAccount, ARobotThatStaysIsStuckFromTheFirstMomentOfTheMinute) {
  const ActivityTimes times = account_for(seconds{64}, standing, always_driving);

  EXPECT_GT(times.stuck, seconds{60});
  EXPECT_EQ(sum(times), seconds{64});
}

TEST(ActivityAccount, FiftyEightSecondsOnOneSpotAreNotStuck) {
  const auto pausing = [](double now_s) { return now_s < 58.0 ? Place{0, 0} : Place{now_s - 58.0, 0}; };

  EXPECT_EQ(account_for(seconds{128}, pausing, always_driving).stuck, seconds{0});
}

TEST(ActivityAccount, OnlyTheStretchOnOneSpotIsStuckAndNotTheWayToIt) {
  const auto arriving = [](double now_s) {
    if (now_s < 100.0) return Place{now_s, 0};
    return now_s < 200.0 ? Place{100, 0} : Place{now_s - 100.0, 0};
  };

  const ActivityTimes times = account_for(seconds{320}, arriving, always_driving);

  EXPECT_NEAR(in_seconds(times.stuck), 100.0, 2.0);
  EXPECT_EQ(times.longest_stuck, times.stuck);
  EXPECT_EQ(sum(times), seconds{320});
}

TEST(ActivityAccount, ComingBackToTheSamePlaceAfterAMinuteIsNotStuck) {
  const auto there_and_back = [](double now_s) { return Place{now_s < 30.0 ? now_s : 60.0 - now_s, 0}; };

  EXPECT_EQ(account_for(seconds{64}, there_and_back, always_driving).stuck, seconds{0});
}

TEST(ActivityAccount, CirclingWithinHalfAMetreIsStuck) {
  const auto dancing = [](double now_s) {
    return Place{0.2 * std::cos(0.3 * now_s), 0.2 * std::sin(0.3 * now_s)};
  };

  EXPECT_NEAR(in_seconds(account_for(seconds{160}, dancing, always_driving).stuck), 160.0, 2.0);
}

TEST(ActivityAccount, AMinuteWithAnExchangeInItIsNotStuck) {
  const auto exchanging = [](double now_s) {
    return now_s >= 32.0 && now_s < 34.0 ? Activity::kExchanging : Activity::kDriving;
  };

  const ActivityTimes times = account_for(seconds{80}, standing, exchanging);

  EXPECT_EQ(times.stuck, seconds{0});
  EXPECT_NEAR(in_seconds(times.exchanging), 2.0, 0.05);
}

TEST(ActivityAccount, AnAbsentRobotIsIdleAndNeverStuck) {
  const ActivityTimes times =
      account_for(seconds{160}, standing, always_driving, [](double) { return false; });

  EXPECT_EQ(times.idle, seconds{160});
  EXPECT_EQ(times.stuck, seconds{0});
}

TEST(ActivityAccount, TheLongestStretchIsNotTheSumOfTwo) {
  const auto twice = [](double now_s) {
    if (now_s < 100.0) return Place{0, 0};
    if (now_s < 200.0) return Place{now_s - 100.0, 0};
    return Place{100, 0};
  };

  const ActivityTimes times = account_for(seconds{384}, twice, always_driving);

  EXPECT_NEAR(in_seconds(times.stuck), 284.0, 3.0);
  EXPECT_NEAR(in_seconds(times.longest_stuck), 184.0, 2.0);
}

}  // namespace
}  // namespace caravan::experiment
