// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace caravan::radio {
namespace {

TEST(Propagation, AHardDiscEndsAtExactlyTheRange) {
  const PropagationConfig config{.range_m = 2.0, .loss_probability = 0.25};
  EXPECT_TRUE(propagate(config, 0.0));
  EXPECT_TRUE(propagate(config, 4.0));
  EXPECT_FALSE(propagate(config, std::nextafter(4.0, 5.0)));
}

TEST(Propagation, AHardDiscLosesAlikeEverywhereAndSaysNothingOfSignalStrength) {
  const PropagationConfig config{.range_m = 2.0, .loss_probability = 0.25};
  for (const double distance_m : {0.0, 1.0, 2.0}) {
    const auto link = propagate(config, distance_m * distance_m);
    ASSERT_TRUE(link);
    EXPECT_EQ(link->loss_probability, 0.25);
    EXPECT_TRUE(std::isnan(link->signal_strength_dbm));
  }
}

TEST(Propagation, NothingArrivesBeyondTheGreatestRange) {
  for (const double range_m : {0.1, 2.0, 250.0}) {
    const PropagationConfig config{.range_m = range_m};
    const double greatest_m = greatest_range_m(config);
    EXPECT_TRUE(propagate(config, greatest_m * greatest_m));
    EXPECT_FALSE(propagate(config, greatest_m * greatest_m * 1.0001));
  }
}

}  // namespace
}  // namespace caravan::radio
