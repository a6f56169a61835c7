// SPDX-License-Identifier: Apache-2.0
// Packets, commands and SIPs, byte by byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::bridge::arcos {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string in_hex(const Bytes& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    text += text.empty() ? "" : " ";
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 0xfU];
  }
  return text;
}

struct Golden {
  Bytes packet;
  std::string bytes;
};

TEST(ArcosCommand, IsEncodedAsTheManualHasIt) {
  const Golden table[] = {
      {encode(Order::kPulse), "FA FB 03 00 00 00"},
      {encode(Order::kOpen), "FA FB 03 01 00 01"},
      {encode(Order::kClose), "FA FB 03 02 00 02"},
      {encode(Order::kEnable, 1), "FA FB 06 04 3B 01 00 05 3B"},
      {encode(Order::kSonar, 1), "FA FB 06 1C 3B 01 00 1D 3B"},
      {encode(Order::kSpeed, 200), "FA FB 06 0B 3B C8 00 D3 3B"},
      {encode(Order::kSpeed, -200), "FA FB 06 0B 1B C8 00 D3 1B"},
      {encode(Order::kTurnRate, -15), "FA FB 06 15 1B 0F 00 24 1B"},
      {encode(Order::kWheelSpeeds, wheel_speeds_argument(0.3, 0.2)), "FA FB 06 20 3B 0A 0F 2A 4A"},
      {encode(Order::kWheelSpeeds, wheel_speeds_argument(-0.3, 0.2)), "FA FB 06 20 3B 0A F1 2B 2C"},
      {encode(Order::kStop), "FA FB 03 1D 00 1D"},
      {encode(Order::kEmergencyStop), "FA FB 03 37 00 37"},
  };
  for (const Golden& golden : table) EXPECT_EQ(in_hex(golden.packet), golden.bytes);
}

TEST(ArcosCommand, ComesBackFromItsBytes) {
  for (const int argument : {0, 1, -1, 300, -300, 65535, -65535}) {
    const Command command{21, argument};
    PacketFinder finder;
    const auto found = finder.feed(encode(command));
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(decode_command(found[0]), command);
  }
  EXPECT_EQ(decode_command(Bytes{29}), (Command{29, {}}));
  EXPECT_EQ(decode_command(Bytes{60, 0x2b, 'a', 'b'}), (Command{60, std::string{"ab"}}));
}

TEST(ArcosCommand, IsRefusedWhenItsArgumentIsTorn) {
  EXPECT_EQ(decode_command(Bytes{}), std::nullopt);
  EXPECT_EQ(decode_command(Bytes{11, 0x3b, 1}), std::nullopt);
  EXPECT_EQ(decode_command(Bytes{11, 0x77, 1, 0}), std::nullopt);
}

TEST(ArcosWheelSpeeds, AreRoundedTo20AndClampedTo126Units) {
  EXPECT_EQ(wheel_speeds_of(wheel_speeds_argument(0.109, -0.111)), (WheelSpeeds{100, -120}));
  EXPECT_EQ(wheel_speeds_of(wheel_speeds_argument(99.0, -99.0)), (WheelSpeeds{2520, -2520}));
  EXPECT_EQ(wheel_speeds_of(wheel_speeds_argument(0.0, 0.0)), (WheelSpeeds{0, 0}));
}

TEST(ArcosChecksum, TakesALastOddByteByExclusiveOr) {
  EXPECT_EQ(checksum(Bytes{0x12}), 0x12);
  EXPECT_EQ(checksum(Bytes{0x12, 0x34, 0x56}), 0x1234 ^ 0x56);
  EXPECT_EQ(checksum(Bytes{0xff, 0xff, 0x00, 0x02}), 0x0001) << "modulo 65536";
}

TEST(ArcosPacketFinder, FindsPacketsBetweenGarbageHoweverTheBytesAreCut) {
  Bytes stream{0x00, 0xfa, 0x13};
  for (const Bytes& packet : {encode(Order::kPulse), encode(Order::kSpeed, 200), encode(Order::kStop)}) {
    stream.insert(stream.end(), packet.begin(), packet.end());
    stream.push_back(0xfb);
  }
  for (std::size_t size = 1; size <= stream.size(); ++size) {
    SCOPED_TRACE(size);
    PacketFinder finder;
    std::vector<Bytes> found;
    for (std::size_t at = 0; at < stream.size(); at += size) {
      const std::span<const std::uint8_t> rest{stream.data() + at, std::min(size, stream.size() - at)};
      for (Bytes& data : finder.feed(rest)) found.push_back(std::move(data));
    }
    EXPECT_THAT(found, ElementsAre(Bytes{0}, Bytes{11, 0x3b, 0xc8, 0x00}, Bytes{29}));
    EXPECT_EQ(finder.stray_bytes(), 6U);
  }
}

TEST(ArcosPacketFinder, FindsThePacketBehindATornOne) {
  Bytes stream = encode(Order::kSpeed, 200);
  stream.resize(5);
  const Bytes whole = encode(Order::kTurnRate, -15);
  stream.insert(stream.end(), whole.begin(), whole.end());
  PacketFinder finder;
  EXPECT_THAT(finder.feed(stream), ElementsAre(Bytes{21, 0x1b, 0x0f, 0x00}));
  EXPECT_EQ(finder.bad_checksums(), 1U);
}

TEST(ArcosPacketFinder, RefusesAChangedByte) {
  for (std::size_t at = 3; at < 9; ++at) {
    Bytes packet = encode(Order::kSpeed, 200);
    packet[at] ^= 0x40U;
    PacketFinder finder;
    EXPECT_THAT(finder.feed(packet), IsEmpty()) << "byte " << at;
  }
}

Sip some_sip() {
  Sip sip;
  sip.moving = true;
  sip.x = 0x0102;
  sip.y = 0x7ffe;
  sip.heading = -5;
  sip.left_mmps = -300;
  sip.right_mmps = 250;
  sip.battery_dv = 126;
  sip.stall_and_bumpers = kRightStall;
  sip.control = 7;
  sip.flags = kMotorsOn | kStopPressed;
  sip.compass = 45;
  sip.sonars = {{3, 1234}, {12, 5000}};
  return sip;
}

TEST(ArcosSip, HasItsFieldsWhereTheManualHasThem) {
  const Bytes packet = to_packet(encode(some_sip()));
  EXPECT_EQ(in_hex(packet).substr(0, 6 * 3), "FA FB 1C 33 02 01 ") << "offsets 0 to 5";
  EXPECT_EQ(packet[8], 0xfb) << "THPOS";
  EXPECT_EQ(packet[10], 0xd4) << "L VEL";
  EXPECT_EQ(packet[14], 126) << "BATTERY";
  EXPECT_EQ(packet[16], 1) << "STALL, right";
  EXPECT_EQ(packet[17], 7) << "CONTROL";
  EXPECT_EQ(packet[19], 0x21) << "FLAGS";
  EXPECT_EQ(packet[21], 45) << "COMPASS";
  EXPECT_EQ(packet[22], 2) << "sonar count";
  EXPECT_EQ(packet[23], 3) << "first index";
  EXPECT_EQ(packet[24] | packet[25] << 8, 1234);
}

TEST(ArcosSip, ComesBackFromItsBytesWithEachLengthOfItsTail) {
  Sip sip = some_sip();
  EXPECT_EQ(decode_sip(encode(sip)), sip);
  sip.gripper = std::uint8_t{1};
  EXPECT_EQ(decode_sip(encode(sip)), sip);
  sip.analog_port = sip.analog = sip.digital_in = sip.digital_out = std::uint8_t{9};
  EXPECT_EQ(decode_sip(encode(sip)), sip);
  sip.battery_fine_dv = std::uint16_t{1260};
  sip.charge = std::uint8_t{2};
  sip.turn_rate = std::int16_t{-40};
  sip.fault = std::uint16_t{3};
  EXPECT_EQ(decode_sip(encode(sip)), sip);
}

TEST(ArcosSip, TakesFieldsThatItDoesNotKnowAndRefusesATornOne) {
  Bytes data = encode(some_sip());
  for (std::size_t size = 0; size < data.size(); ++size) {
    EXPECT_EQ(decode_sip(std::span{data.data(), size}), std::nullopt) << size;
  }
  Sip whole = some_sip();
  whole.gripper = whole.analog_port = whole.analog = whole.digital_in = whole.digital_out = std::uint8_t{0};
  whole.battery_fine_dv = std::uint16_t{0};
  whole.charge = std::uint8_t{0};
  whole.turn_rate = std::int16_t{0};
  whole.fault = std::uint16_t{0};
  data = encode(whole);
  data.insert(data.end(), {1, 2, 3});
  EXPECT_EQ(decode_sip(data), whole);
}

TEST(ArcosNames, ComeBackFromTheAnswerToTheThirdSync) {
  const Names names{"Fred", "Pioneer", "p3dx"};
  EXPECT_EQ(decode_names(encode(names)), names);
  EXPECT_EQ(decode_names(Bytes{2, 'F', 'r', 'e', 'd'}), std::nullopt);
  EXPECT_EQ(decode_names(Bytes{1}), std::nullopt);
}

TEST(ArcosSettings, HaveTheWatchdogBehindTheirNamesAndComeBackFromTheirBytes) {
  const Settings settings{.type = "Pioneer",
                          .subtype = "p3dx",
                          .serial_number = "77",
                          .top_speed_mmps = 2200,
                          .name = "Fred",
                          .sip_period_ms = 100,
                          .low_battery_dv = 115,
                          .watchdog_ms = 2000};
  Bytes data = encode(settings);
  EXPECT_EQ(data[0], 0x20);
  const std::size_t names = std::string{"Pioneer"}.size() + std::string{"p3dx"}.size() + 2 + 4 + 4;
  const std::size_t before = 1 + names + 1 + 5 * 2 + 3 + 2 * 2 + 1 + 2 * 2;
  EXPECT_EQ(data.size(), before + 2);
  EXPECT_EQ(data[before] | data[before + 1] << 8, 2000);
  for (std::size_t size = 0; size < data.size(); ++size) {
    EXPECT_EQ(decode_settings(std::span{data.data(), size}), std::nullopt) << size;
  }
  data.insert(data.end(), {1, 2, 3});
  EXPECT_EQ(decode_settings(data), settings) << "what follows is not ours";
}

TEST(ArcosProperty, AnyBytesBetweenPacketsLoseNoneOfThem) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    PacketFinder finder;
    std::size_t found = 0;
    for (int packet = 0; packet < 10; ++packet) {
      Bytes stream;
      // Garbage that cannot be the head of a packet: what looks like one may swallow what follows it.
      for (int byte = 0; byte < 20; ++byte) stream.push_back(static_cast<std::uint8_t>(random.word() % 0xfa));
      const Bytes whole = encode(some_sip());
      const Bytes framed = to_packet(whole);
      stream.insert(stream.end(), framed.begin(), framed.end());
      for (const Bytes& data : finder.feed(stream)) found += data == whole ? 1 : 0;
    }
    EXPECT_EQ(found, 10U);
  }
}

}  // namespace
}  // namespace caravan::bridge::arcos
