// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/robot/dead_reckoning.hpp"

namespace caravan::bridge {
namespace {

using arcos::Moved;
using arcos::Odometry;
using arcos::Sip;
using namespace std::chrono_literals;

Sip sip_at(int x, int y, int heading) {
  Sip sip;
  sip.x = static_cast<std::uint16_t>(x);
  sip.y = static_cast<std::uint16_t>(y);
  sip.heading = static_cast<std::int16_t>(heading);
  return sip;
}

TEST(Odometry, FactorsAreThoseOfTheSubtype) {
  EXPECT_DOUBLE_EQ(arcos::factors_of("p3dx").value().position_m, 0.485e-3);
  EXPECT_DOUBLE_EQ(arcos::factors_of("p3dx-sh").value().position_m, 1.0e-3);
  EXPECT_FALSE(arcos::factors_of("amigo"));
}

TEST(Odometry, CountsWayFromTheSecondSipOn) {
  Odometry odometry{*arcos::factors_of("p3dx")};
  EXPECT_EQ(odometry.follow(sip_at(1000, 500, 0)).ahead_m, 0.0);
  EXPECT_NEAR(odometry.follow(sip_at(1200, 500, 0)).ahead_m, 0.097, 1e-9);
  EXPECT_NEAR(odometry.follow(sip_at(1100, 500, 0)).ahead_m, -0.0485, 1e-9) << "backward";
  odometry.restart();
  EXPECT_EQ(odometry.follow(sip_at(0, 0, 0)).ahead_m, 0.0);
}

TEST(Odometry, PositionWrapsAt15BitsInBothDirections) {
  Odometry odometry{{.position_m = 0.001}};
  (void)odometry.follow(sip_at(32760, 0, 0));
  EXPECT_NEAR(odometry.follow(sip_at(8, 0, 0)).ahead_m, 0.016, 1e-9);
  EXPECT_NEAR(odometry.follow(sip_at(32760, 0, 0)).ahead_m, -0.016, 1e-9);
  EXPECT_NEAR(odometry.follow(sip_at(0x8000 | 32760, 0, 0)).ahead_m, 0.0, 1e-9)
      << "the 16th bit counts nothing";
}

TEST(Odometry, HeadingWrapsAtATurn) {
  Odometry odometry{{.position_m = 0.001}};
  (void)odometry.follow(sip_at(0, 0, 4090));
  EXPECT_NEAR(odometry.follow(sip_at(0, 0, 4)).turned_rad, 10 * 2.0 * std::numbers::pi / 4096, 1e-9);
  EXPECT_NEAR(odometry.follow(sip_at(0, 0, 4090)).turned_rad, -10 * 2.0 * std::numbers::pi / 4096, 1e-9);
}

TEST(Odometry, IsTheRobotsReckoningOverTwoHundredMetresOfTurns) {
  for (const char* subtype : {"p3dx", "p3dx-sh"}) {
    SCOPED_TRACE(subtype);
    constexpr double kTrack_m = 0.33;
    constexpr double kRadius_m = 0.0975;
    const arcos::Factors factors = *arcos::factors_of(subtype);
    DeadReckoning robot{factors, kTrack_m, kRadius_m};
    Odometry host{factors};
    double left = 0.0;
    double right = 0.0;
    double told_ahead = 0.0;
    double told_turned = 0.0;
    robot.turn(0.0, 0.0, 0ms);
    (void)host.follow(Sip{});
    for (int step = 0; step < 2000; ++step) {
      left += (0.10 - 0.02 * std::sin(0.01 * step)) / kRadius_m;
      right += (0.10 + 0.02 * std::sin(0.01 * step)) / kRadius_m;
      robot.turn(left, right, 100ms * (step + 1));
      Sip sip;
      robot.write(sip);
      const Moved moved = host.follow(sip);
      told_ahead += moved.ahead_m;
      told_turned += moved.turned_rad;
    }
    EXPECT_NEAR(told_ahead, 200.0, 0.1);
    EXPECT_NEAR(std::remainder(told_turned - robot.yaw_rad(), 2.0 * std::numbers::pi), 0.0, 0.05);
  }
}

}  // namespace
}  // namespace caravan::bridge
