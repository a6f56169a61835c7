// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/config/radio_config.hpp"

#include <gmock/gmock.h>

namespace caravan::radio {
namespace {

using runtime::StartError;
using runtime::TomlDocument;

TEST(RadioConfig, ReadsEveryKeyOfTheRadioTableAndTheSeed) {
  const MediumConfig config = load_radio_config(TomlDocument::parse(R"(
seed = 9
[radio]
range_m = 3.5
channel_count = 16
mtu_bytes = 100
queue_length = 8
loss_probability = 0.25
)",
                                                                    "test.toml"));
  EXPECT_EQ(config.propagation.range_m, 3.5);
  EXPECT_EQ(config.channel_count, 16U);
  EXPECT_EQ(config.mtu_bytes, 100U);
  EXPECT_EQ(config.queue_length, 8U);
  EXPECT_EQ(config.propagation.loss_probability, 0.25);
  EXPECT_EQ(config.seed, 9U);
}

TEST(RadioConfig, IsThePapersRadioWhenTheFileSaysNothing) {
  const MediumConfig config = load_radio_config(TomlDocument::parse("", "test.toml"));
  EXPECT_EQ(config.propagation.range_m, 2.0);
  EXPECT_EQ(config.channel_count, 1U << 20U);
  EXPECT_EQ(config.propagation.loss_probability, 0.0);
}

TEST(RadioConfig, NamesFileLineAndKeyOfANegativeRange) {
  try {
    (void)load_radio_config(TomlDocument::parse("[radio]\nrange_m = -2\n", "test.toml"));
    FAIL() << "was accepted";
  } catch (const StartError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("test.toml:2: radio.range_m: "));
  }
}

TEST(RadioConfig, RefusesAnUnknownKey) {
  EXPECT_THROW((void)load_radio_config(TomlDocument::parse("[radio]\nrange = 2\n", "test.toml")), StartError);
}

}  // namespace
}  // namespace caravan::radio
