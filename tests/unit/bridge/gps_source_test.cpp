// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/gps_source.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

bool takes(GpsSource& source, double time_of_day_s, Time now) {
  const std::string line = nmea::to_line(nmea::Gga{time_of_day_s, 48.0, 11.0, 1, 9, 0.9});
  const auto news =
      source.feed({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, {0.0, 0.0}, now);
  return news.size() == 1 && std::holds_alternative<GpsSource::Fix>(news.front());
}

TEST(GpsSource, AReceiverOnAnotherLineMayHaveAnotherTime) {
  GpsSource source{{48.0, 11.0, 0.0}, 5.0};
  for (int i = 0; i < 10; ++i) (void)takes(source, 2.0 + 0.1 * i, 2s + i * 100ms);
  EXPECT_TRUE(takes(source, 3.0, 3s));
  EXPECT_FALSE(takes(source, 3.1, 8s)) << "five seconds late";
  source.restart();
  EXPECT_TRUE(takes(source, 3.4, 10s)) << "switched off and on: it counts from its start";
}

/// The notices in the first 20 s when the receiver sends this line every second.
std::string told_of(const std::string& line) {
  GpsSource source{{48.0, 11.0, 0.0}, 5.0};
  std::string told;
  for (Time now{0}; now < 20s; now += 500ms) {
    if (now % 1s == 0s)
      (void)source.feed({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, {0.0, 0.0}, now);
    source.tick(now);
    for (const Notice& notice : source.take_notices()) told += in_seconds(now) + " " + notice.text + "\n";
  }
  return told;
}

TEST(GpsSource, TellsOnceThatThereIsNoFixFromTheStart) {
  const std::string no_fix = nmea::to_line(nmea::Gga{});
  EXPECT_EQ(told_of(no_fix),
            "10.0 s GPS: the receiver has no fix in the first 10.0 s: does its antenna see the sky?\n");
  EXPECT_THAT(told_of(""), HasSubstr("10.0 s GPS: the receiver has sent nothing in the first 10.0 s"));
  EXPECT_THAT(told_of("$GPZDA,,,,,,*48\r\n"), HasSubstr("10.0 s GPS: the receiver has sent no GGA"));
}

TEST(GpsSource, CountsTheTimeToTheFirstFixWhileThereIsALine) {
  GpsSource source{{48.0, 11.0, 0.0}, 5.0};
  for (Time now{0}; now < 30s; now += 500ms) {
    source.restart();
    source.tick(now);
  }
  EXPECT_THAT(source.take_notices(), IsEmpty());
}

TEST(GpsSource, TellsNothingOfAFirstFixThatCame) {
  GpsSource source{{48.0, 11.0, 0.0}, 5.0};
  source.tick(0s);
  for (int i = 0; i < 10; ++i) (void)takes(source, 2.0 + 0.1 * i, 2s + i * 100ms);
  source.tick(20s);
  EXPECT_THAT(source.take_notices(), IsEmpty());
}

}  // namespace
}  // namespace caravan::bridge
