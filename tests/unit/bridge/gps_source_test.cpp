// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "hardware_bridge/core/host/gps_source.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;

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

}  // namespace
}  // namespace caravan::bridge
