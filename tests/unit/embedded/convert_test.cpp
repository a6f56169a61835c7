// SPDX-License-Identifier: Apache-2.0
#include "experiment/embedded/convert.hpp"

#include <gtest/gtest.h>

namespace caravan::experiment {
namespace {

TEST(Heard, HasChannelBytesAndSignalStrengthOfWhatTheRadioDelivers) {
  radio::Reception reception{.robot = 2,
                             .frames = {{.channel = 5, .bytes = {1, 2}, .signal_strength_dbm = -71.5}}};
  const auto heard = to_heard(reception);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].channel, 5U);
  EXPECT_EQ(heard[0].bytes, (std::vector<std::uint8_t>{1, 2}));
  EXPECT_EQ(heard[0].signal_strength_dbm, -71.5);
}

}  // namespace
}  // namespace caravan::experiment
