// SPDX-License-Identifier: Apache-2.0
// Packets, commands and SIPs, byte by byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/reports.hpp"
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

TEST(ArcosSettings, HaveEachFieldWhereHostsReadIt) {
  const Settings delivered{.serial_number = "77", .name = "Fred", .firmware = "2.9"};
  EXPECT_EQ(in_hex(encode(delivered)),
            "20 50 69 6F 6E 65 65 72 00 "                 // Pioneer
            "70 33 64 78 00 37 37 00 "                    // p3dx, 77
            "00 68 01 DC 05 58 02 A0 0F F4 01 "           // tops: 360, 1500, 600, 4000; 500
            "46 72 65 64 00 "                             // Fred
            "64 00 00 00 00 01 00 01 6E 00 BA 40 D0 07 "  // SIP 100 ms to watchdog 2000 ms
            "00 C8 00 64 00 00 00 00 00 "                 // stall 200, 100; joystick
            "64 00 EE 02 64 00 64 00 28 00 14 00 00 00 "  // maxima 100, 750; turning
            "2C 01 2C 01 28 00 14 00 00 00 "              // 300, 300; gains
            "00 00 00 28 02 00 00 00 00 00 80 00 00 00 "  // bumpers to shutdown
            "32 2E 39 00 "                                // 2.9
            "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00");
  EXPECT_LE(encode(delivered).size(), kMostData);
}

TEST(ArcosSettings, OfAnOlderRobotEndEarlier) {
  const Settings settings{.type = "Pioneer",
                          .subtype = "p3dx-sh",
                          .serial_number = "77",
                          .top_speed_mmps = 2200,
                          .name = "Fred",
                          .low_battery_dv = 115,
                          .watchdog_ms = 2000,
                          .max_speed_mmps = 600,
                          .firmware = "2.9"};
  Bytes data = encode(settings);
  EXPECT_EQ(decode_settings(data), settings);
  data.insert(data.end(), {1, 2, 3});
  EXPECT_EQ(decode_settings(data), settings) << "what follows is not known";
  const std::size_t names = std::string{"Pioneerp3dx-sh77Fred"}.size() + 4;
  const std::size_t watchdog_ends = 1 + names + 1 + 5 * 2 + 3 + 2 * 2 + 1 + 3 * 2;
  for (std::size_t size = 0; size < watchdog_ends; ++size) {
    EXPECT_EQ(decode_settings(std::span{data.data(), size}), std::nullopt) << size;
  }
  for (std::size_t size = watchdog_ends; size < data.size(); ++size) {
    const auto older = decode_settings(std::span{data.data(), size});
    ASSERT_TRUE(older) << size;
    EXPECT_EQ(older->watchdog_ms, 2000);
  }
  const auto oldest = decode_settings(std::span{data.data(), watchdog_ends});
  EXPECT_EQ(oldest->max_speed_mmps, 0) << "it has not told";
  EXPECT_EQ(oldest->ticks_per_mm, 0);
}

TEST(ArcosReports, HaveTheirFieldsWhereHostsReadThem) {
  EXPECT_EQ(in_hex(encode(EncoderReport{0x01020304, -2})), "90 04 03 02 01 FE FF FF FF");
  EXPECT_EQ(
      in_hex(encode(IoReport{.digital_in = 0x39, .front_bumpers = 2, .digital_out = 5, .analog = {0x3ff}})),
      "F0 04 39 02 00 FF 01 05 09 FF 03 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00");
  EXPECT_EQ(in_hex(encode(GripperReport{.state = kPaddlesClosed, .grasp_time = 3})), "E0 01 02 03");
  EXPECT_EQ(in_hex(encode(JoystickReport{.button_1 = 1, .x = 0x123})), "F8 01 00 23 01 00 02 00 00");
}

TEST(ArcosProperty, AnyBytesBetweenPacketsLoseNoneOfThem) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    PacketFinder finder;
    std::size_t found = 0;
    for (int packet = 0; packet < 10; ++packet) {
      Bytes stream;
      // Garbage that cannot start a packet: bytes that look like a header could swallow those that follow.
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
