// SPDX-License-Identifier: Apache-2.0
// An emulated Pioneer as its host sees it: commands, motion, sonars and GPS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "tests/system/bridge/support/arcos_host.hpp"
#include "tests/system/bridge/support/arcos_robot.hpp"
#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {
namespace {

using bridge::arcos::Bytes;
using bridge::arcos::encode;
using bridge::arcos::Order;
using bridge::arcos::Sip;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

/// Bytes from their notation in hexadecimal: "FA FB 03".
Bytes from_hex(const std::string& text) {
  Bytes bytes;
  std::istringstream in{text};
  for (unsigned byte = 0; in >> std::hex >> byte;) bytes.push_back(static_cast<std::uint8_t>(byte));
  return bytes;
}

TEST_F(ArcosRobot, ShakesHandsAsAPioneerDoes) {
  Host host{robot_.port};
  ASSERT_TRUE(host.is_connected());
  host.say(encode(Order::kPulse));
  EXPECT_EQ(host.next(), Bytes{0});
  host.say(encode(Order::kOpen));
  EXPECT_EQ(host.next(), Bytes{1});
  host.say(encode(Order::kClose));
  const auto names = bridge::arcos::decode_names(host.next().value_or(Bytes{}));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->type, "Pioneer");
  EXPECT_EQ(names->subtype, "p3dx");
  host.say(encode(Order::kOpen));
  EXPECT_TRUE(host.sip([](const Sip&) { return true; })) << robot_.process->output();
}

/// The packets of the most common client library for Pioneers, in its order of opening, configuring and
/// closing.
TEST_F(ArcosRobot, AProgramForRealPioneersConfiguresMovesTurnsAndCloses) {
  Host host{robot_.port};
  for (const char* sync : {"FA FB 03 00 00 00", "FA FB 03 01 00 01", "FA FB 03 02 00 02"}) {
    host.say(from_hex(sync));
    ASSERT_TRUE(host.next()) << sync;
  }
  host.say(from_hex("FA FB 06 01 3B 01 00 02 3B"));  // OPEN 1
  host.say(from_hex("FA FB 06 12 3B 01 00 13 3B"));  // CONFIG 1
  std::optional<bridge::arcos::Settings> settings;
  std::optional<Sip> first;
  EXPECT_TRUE(eventually(
      [&] {
        const auto data = host.next();
        if (!data) return false;
        if (!first) first = bridge::arcos::decode_sip(*data);
        if (!settings) settings = bridge::arcos::decode_settings(*data);
        return first && settings;
      },
      kPatience))
      << robot_.process->output();
  EXPECT_EQ(first->flags, 0x1e) << "sonars on, motors off";
  EXPECT_EQ(settings->max_speed_mmps, 750);
  EXPECT_EQ(settings->name, "caravan_1");
  host.say(from_hex("FA FB 06 3E 3B 01 00 3F 3B"));  // BATTERYINFO 1
  host.say(from_hex("FA FB 06 04 3B 01 00 05 3B"));  // ENABLE 1
  host.say(from_hex("FA FB 06 06 3B 2C 01 32 3C"));  // SETV 300
  host.say(from_hex("FA FB 06 0A 3B 3C 00 46 3B"));  // SETRV 60
  const auto begin = truth_.of(1);
  host.say(from_hex("FA FB 06 08 1B C8 00 D0 1B"));  // MOVE -200, since the robot stands near a wall
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }));
  ASSERT_TRUE(host.sip([](const Sip& sip) { return !sip.moving; }));
  ASSERT_TRUE(truth_.rests(1));
  const auto moved = truth_.of(1);
  EXPECT_NEAR(std::hypot(moved->x_m() - begin->x_m(), moved->y_m() - begin->y_m()), 0.2, 0.03);
  host.say(from_hex("FA FB 06 0D 3B 5A 00 67 3B"));  // DHEAD 90
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.right_mmps > 50; }));
  ASSERT_TRUE(host.sip([](const Sip& sip) { return !sip.moving; }));
  ASSERT_TRUE(truth_.rests(1));
  const auto turned = truth_.of(1);
  EXPECT_NEAR(bridge::wrapped(turned->yaw_rad() - moved->yaw_rad()), 1.571, 0.1);
  host.say(from_hex("FA FB 06 04 3B 00 00 04 3B"));  // ENABLE 0
  ASSERT_TRUE(host.sip([](const Sip& sip) { return (sip.flags & bridge::arcos::kMotorsOn) == 0; }));
  host.say(from_hex("FA FB 06 02 3B 01 00 03 3B"));  // CLOSE 1
  host.say(from_hex("FA FB 06 63 3B 01 00 64 3B"));  // 99: not reported while the robot is closed
  EXPECT_THAT(robot_.process->output(), Not(HasSubstr("does not know")));
}

TEST_F(ArcosRobot, NamesACommandThatItDoesNotKnowOnce) {
  Host host{robot_.port};
  host.open();
  host.say(from_hex("FA FB 06 63 3B 01 00 64 3B"));
  host.say(from_hex("FA FB 06 63 3B 01 00 64 3B"));
  ASSERT_TRUE(robot_.process->prints("command 99, which this robot does not know", kPatience));
  ASSERT_TRUE(host.sip([](const Sip&) { return true; }));
  const std::string output = robot_.process->output();
  EXPECT_EQ(output.find("command 99"), output.rfind("command 99"));
}

TEST_F(ArcosRobot, NamesACommandWithAWrongArgumentOnce) {
  Host host{robot_.port};
  for (int times = 0; times < 3; ++times) host.say(from_hex("FA FB 05 01 3B 01 01 3A"));  // OPEN, one byte
  host.open();
  ASSERT_TRUE(host.sip([](const Sip&) { return true; }));
  const std::string output = robot_.process->output();
  EXPECT_THAT(output, HasSubstr("command 1 with an argument of a wrong kind or length: ignored"));
  EXPECT_EQ(output.find("command 1 with"), output.rfind("command 1 with"));
}

TEST_F(ArcosRobot, DrivesThroughTheWorldAndReckonsAsItDoes) {
  Host host{robot_.port};
  host.open();
  const auto begin = truth_.of(1);
  ASSERT_TRUE(begin);
  bridge::arcos::Odometry odometry{*bridge::arcos::factors_of("p3dx")};
  double turned = 0.0;
  const auto moved = host.sip(
      [&](const Sip& sip) {
        turned += odometry.follow(sip).turned_rad;
        return turned > 1.5;
      },
      wheels(-0.1, 0.1));
  ASSERT_TRUE(moved) << robot_.process->output();
  EXPECT_TRUE(moved->moving);
  EXPECT_TRUE(host.sip([](const Sip& sip) { return !sip.moving; }, encode(Order::kStop)));
  const auto end = truth_.of(1);
  EXPECT_NEAR(bridge::wrapped(end->yaw_rad() - begin->yaw_rad()), turned, 0.25);
}

TEST_F(ArcosRobot, SonarsComeInTurnAndSeeTheWorld) {
  Host host{robot_.port};
  host.open();
  std::map<int, int> seen;
  const auto all = host.sip([&](const Sip& sip) {
    for (const Sip::Sonar& sonar : sip.sonars) seen[sonar.index] = sonar.range_mm;
    return seen.size() == bridge::kSonarCount;
  });
  ASSERT_TRUE(all) << seen.size();
  EXPECT_LT(all->sonars.size(), bridge::kSonarCount) << "one of each array at a time";
  EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [](const auto& one) { return one.second < 5000; }))
      << "some wall of the room";
}

TEST_F(ArcosRobot, TheWatchdogStopsARobotWhoseHostSaysNothing) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
  EXPECT_TRUE(eventually(
      [&] {
        const auto data = host.next();
        const auto sip = data ? bridge::arcos::decode_sip(*data) : std::nullopt;
        return sip && !sip->moving;
      },
      kPatience));
}

/// The first position that the GPS receiver on `port` reports, in the arena of room().
std::optional<bridge::Point> told_by_gps(std::uint16_t port) {
  const auto receiver = Socket::to(port);
  if (!receiver) return std::nullopt;
  const bridge::ArenaProjection projection{{48.137, 11.575, 0.3}};
  bridge::nmea::SentenceFinder sentences;
  std::optional<bridge::Point> told;
  (void)eventually(
      [&] {
        const auto bytes = receiver->read(50ms).value_or(Bytes{});
        for (const std::string& sentence : sentences.feed(bytes)) {
          const auto parsed = bridge::nmea::parse(sentence);
          const auto* gga = parsed ? std::get_if<bridge::nmea::Gga>(&*parsed) : nullptr;
          if (gga != nullptr) told = projection.to_arena(gga->latitude_deg, gga->longitude_deg);
        }
        return told.has_value();
      },
      kPatience);
  return told;
}

TEST_F(ArcosRobot, ItsGpsSaysWhereItIsOnEarth) {
  const auto told = told_by_gps(robot_.gps_port);
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->x_m, truth_.of(1)->x_m(), 0.01);
  EXPECT_NEAR(told->y_m, truth_.of(1)->y_m(), 0.01);
}

TEST_F(Field, TheGpsReceiverStandsWhereTheAntennaIsMounted) {
  const auto world = start_world(room(1, 0) + "antenna_m = [-1.0, 0.5]\n", "1");
  const Robot robot = start_robot(1);
  const Truth truth{bus()};
  ASSERT_TRUE(truth.is_there()) << world->output();
  const auto told = told_by_gps(robot.gps_port);
  ASSERT_TRUE(told) << robot.process->output();
  const auto base = truth.of(1);
  const double yaw = base->yaw_rad();
  EXPECT_NEAR(told->x_m, base->x_m() - std::cos(yaw) - 0.5 * std::sin(yaw), 0.02);
  EXPECT_NEAR(told->y_m, base->y_m() - std::sin(yaw) + 0.5 * std::cos(yaw), 0.02);
}

}  // namespace
}  // namespace caravan::test
