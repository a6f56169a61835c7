// SPDX-License-Identifier: Apache-2.0
// Packets between radios, and a radio that cannot send and receive at the same time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/modem/air_packet.hpp"
#include "hardware_bridge/core/modem/half_duplex.hpp"

namespace caravan::bridge::modem {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(AirPacket, ComesBackFromItsBytesAndNotWithABitChanged) {
  const AirPacket packet{0x01020304, 125, {0xc0, 0xdb, 0, 255}};
  const Bytes bytes = encode(packet);
  EXPECT_EQ(decode(bytes), packet);
  EXPECT_EQ(decode(encode({7, 0, {}})), (AirPacket{7, 0, {}}));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes wrong = bytes;
    wrong[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_EQ(decode(wrong), std::nullopt) << bit;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(decode(std::span{bytes.data(), size}), std::nullopt);
}

TEST(Slip, FindsPacketsWhateverTheyHoldAndHoweverTheyAreCut) {
  const Bytes first{0xc0, 0xdb, 0xdc, 0xdd, 1};
  const Bytes second{2};
  Bytes stream{9, 9};
  for (const Bytes& packet : {first, second}) {
    const Bytes framed = to_slip(packet);
    stream.insert(stream.end(), framed.begin(), framed.end());
  }
  SlipReader reader;
  std::vector<Bytes> found;
  for (const std::uint8_t byte : stream) {
    for (Bytes& packet : reader.feed({&byte, 1})) found.push_back(std::move(packet));
  }
  EXPECT_THAT(found, ElementsAre(Bytes{9, 9}, first, second)) << "noise is a packet that decodes to nothing";
}

TEST(HalfDuplex, RefusesWhatTheRadioCannotSend) {
  HalfDuplex radio{{.mtu_bytes = 32, .channel_count = 126, .queue_length = 1}};
  radio.send({0, Bytes(33)}, 0s);
  radio.send({126, Bytes(1)}, 0s);
  EXPECT_EQ(radio.over_mtu(), 1U);
  EXPECT_EQ(radio.bad_channel(), 1U);
  EXPECT_EQ(radio.next(1s), std::nullopt);
  radio.send({0, Bytes(32)}, 1s);
  radio.send({0, Bytes(32)}, 1s);
  EXPECT_EQ(radio.queue_full(), 1U);
}

TEST(HalfDuplex, IsDeafWhileItSends) {
  HalfDuplex radio{{.bit_rate_bps = 250000.0}};
  EXPECT_TRUE(radio.hears(0, 0s));
  radio.send({0, Bytes(32)}, 0s);
  EXPECT_FALSE(radio.hears(0, 0s));
  ASSERT_TRUE(radio.next(0s));
  EXPECT_FALSE(radio.hears(0, 1300us)) << "41 bytes take 1.312 ms";
  EXPECT_TRUE(radio.hears(0, 1313us));
}

TEST(HalfDuplex, ChangesItsChannelForAFrameAndBackAndIsDeafMeanwhile) {
  HalfDuplex radio{{.bit_rate_bps = 1000000.0, .channel_change = 1ms}};
  radio.tune(5, 0s);
  EXPECT_FALSE(radio.hears(5, 500us));
  EXPECT_TRUE(radio.hears(5, 1ms));
  EXPECT_FALSE(radio.hears(0, 1ms)) << "it is on one channel at a time";
  radio.send({0, Bytes(16)}, 10ms);
  EXPECT_EQ(radio.next(10500us), std::nullopt) << "still changing";
  EXPECT_EQ(radio.next_deadline(), std::optional<Time>{11ms});
  const auto frame = radio.next(11ms);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->channel, 0U);
  EXPECT_FALSE(radio.hears(5, 12ms)) << "200 us on the air, then the way back";
  EXPECT_TRUE(radio.hears(5, 12200us));
}

TEST(HalfDuplex, SendsInOrderOneAfterTheOther) {
  HalfDuplex radio{{.bit_rate_bps = 80000.0}};
  for (std::uint8_t i = 0; i < 3; ++i) radio.send({0, Bytes(1, i)}, 0s);
  std::vector<std::uint8_t> sent;
  std::vector<Time> at;
  for (Time now{0}; now < 10ms; now += 100us) {
    while (const auto frame = radio.next(now)) {
      sent.push_back(frame->bytes[0]);
      at.push_back(now);
    }
  }
  EXPECT_THAT(sent, ElementsAre(0, 1, 2));
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(static_cast<double>((at[2] - at[0]).count()), 2e6, 2e5) << "10 bytes take 1 ms";
}

}  // namespace
}  // namespace caravan::bridge::modem
