// SPDX-License-Identifier: Apache-2.0
// The bytes that programs for real Pioneers send, and the response of the emulated robot.
#include <gmock/gmock.h>

#include "tests/unit/bridge/robot_bench.hpp"

namespace caravan::bridge {
namespace {

using arcos::Bytes;
using arcos::Order;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

using PioneerHost = RobotBench;

TEST_F(PioneerHost, ShakesHandsAndOpensWithAnArgument) {
  robot_.connected(now_);
  say("FA FB 03 00 00 00");
  EXPECT_EQ(robot_.take_output(), from_hex("FA FB 03 00 00 00"));
  say("FA FB 03 01 00 01");
  EXPECT_EQ(robot_.take_output(), from_hex("FA FB 03 01 00 01"));
  say("FA FB 03 02 00 02");
  EXPECT_EQ(robot_.take_output(),
            from_hex("FA FB 18 02 63 61 72 61 76 61 6E 00 50 69 6F 6E 65 65 72 00 70 33 64 78 "
                     "00 10 23"));
  say("FA FB 06 01 3B 01 00 02 3B");
  run(1s);
  EXPECT_THAT(sips_, SizeIs(11)) << "the first at once";
}

/// A host that opens with any kind of argument gets SIPs and can close.
class AnyArgument : public RobotBench, public ::testing::WithParamInterface<arcos::Command> {
 protected:
  /// The command with the kind of argument under test.
  [[nodiscard]] static Bytes packet(Order order) {
    return encode(arcos::Command{static_cast<std::uint8_t>(order), GetParam().argument});
  }
};
INSTANTIATE_TEST_SUITE_P(Argument, AnyArgument,
                         ::testing::Values(arcos::Command{0, {}}, arcos::Command{0, 1}, arcos::Command{0, -1},
                                           arcos::Command{0, std::string{"on"}}));

TEST_P(AnyArgument, OpensStopsAndCloses) {
  robot_.connected(now_);
  for (const Order order : {Order::kPulse, Order::kOpen, Order::kClose}) say(encode(order));
  say(packet(Order::kOpen));
  run(500ms);
  EXPECT_THAT(sips_, Not(IsEmpty()));
  say(packet(Order::kConfig));
  run(100ms);
  EXPECT_EQ(take_count(0x20), 1);
  say(Order::kEnable, 1);
  for (const Order stop : {Order::kStop, Order::kEmergencyStop}) {
    say(Order::kSpeed, 300);
    run(500ms);
    EXPECT_GT(drive_.left_mps, 0.1);
    say(packet(Order::kPulse));
    say(packet(stop));
    run(1s);
    EXPECT_EQ(drive_.left_mps, 0.0);
  }
  say(packet(Order::kSetOrigin));
  run(200ms);
  EXPECT_EQ(sips_.back().x, 0);
  EXPECT_EQ(robot_.ignored_commands(), 0U);
  say(packet(Order::kClose));
  sips_.clear();
  run(500ms);
  EXPECT_THAT(sips_, IsEmpty());
}

TEST_F(PioneerHost, IsToldTheWholeConfiguration) {
  shake_hands();
  say("FA FB 06 12 3B 01 00 13 3B");
  EXPECT_EQ(
      robot_.take_output(),
      from_hex(
          "FA FB 77 20 50 69 6F 6E 65 65 72 00 70 33 64 78 00 30 00 00 68 01 DC 05 58 02 A0 0F F4 01 63 61 "
          "72 61 76 61 6E 00 64 00 00 01 00 01 00 01 6E 00 BA 40 D0 07 00 C8 00 64 00 00 00 00 00 64 00 EE "
          "02 64 00 64 00 28 00 14 00 00 00 2C 01 2C 01 28 00 14 00 00 00 00 00 00 28 02 00 00 00 00 00 80 "
          "00 00 00 32 2E 39 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 C9 09"));
}

TEST_F(PioneerHost, ChangesTheConfigurationUntilItCloses) {
  shake_hands();
  say("FA FB 06 06 3B 58 02 5E 3D");  // SETV 600
  say("FA FB 06 0A 3B 3C 00 46 3B");  // SETRV 60
  say(Order::kSetAcceleration, 500);
  say("FA FB 06 05 1B D0 07 D5 22");  // SETA -2000
  say(Order::kSetTurnAcceleration, 200);
  say(Order::kSetTurnAcceleration, -300);
  say(Order::kTurnGainP, 7);
  say(Order::kTurnGainV, 8);
  say(Order::kTurnGainI, 9);
  say(Order::kSpeedGainP, 10);
  say(Order::kSpeedGainV, 11);
  say(Order::kSpeedGainI, 12);
  say(Order::kTicksPerTurn, 16000);
  say(Order::kTicksPerMm, 132);
  say(Order::kDriftFactor, -5);
  say(Order::kSonarCycle, 20);
  arcos::Settings expected;
  {
    const arcos::Settings delivered{};
    expected = settings();
    EXPECT_EQ(expected.max_speed_mmps, 600);
    EXPECT_EQ(expected.max_turn_degps, 60);
    EXPECT_EQ(expected.acceleration_mmps2, 500);
    EXPECT_EQ(expected.deceleration_mmps2, 2000);
    EXPECT_EQ(expected.turn_acceleration_degps2, 200);
    EXPECT_EQ(expected.turn_deceleration_degps2, 300);
    EXPECT_THAT((std::array{expected.turn_gain_p, expected.turn_gain_v, expected.turn_gain_i,
                            expected.speed_gain_p, expected.speed_gain_v, expected.speed_gain_i}),
                ElementsAre(7, 8, 9, 10, 11, 12));
    EXPECT_EQ(expected.ticks_per_turn, 16000);
    EXPECT_EQ(expected.ticks_per_mm, 132);
    EXPECT_EQ(expected.drift_factor, -5);
    EXPECT_EQ(expected.sonar_cycle_ms, 20);
    EXPECT_EQ(expected.top_speed_mmps, delivered.top_speed_mmps);
  }
  say("FA FB 06 02 3B 01 00 03 3B");
  shake_hands();
  EXPECT_EQ(settings().max_speed_mmps, 750) << "as delivered";
  EXPECT_EQ(settings().deceleration_mmps2, 300);
}

TEST_F(PioneerHost, SetsNothingAboveTheTops) {
  shake_hands();
  say(Order::kSetMaxSpeed, 9000);
  say(Order::kSetMaxTurnRate, 9000);
  say(Order::kSetAcceleration, 60000);
  say(Order::kSetTurnAcceleration, -60000);
  EXPECT_EQ(settings().max_speed_mmps, 1500);
  EXPECT_EQ(settings().max_turn_degps, 360);
  EXPECT_EQ(settings().acceleration_mmps2, 4000);
  EXPECT_EQ(settings().turn_deceleration_degps2, 600);
}

TEST_F(PioneerHost, HasSonarsWithoutAskingAndSwitchesThem) {
  senses_.sonar_range_m.fill(2.0);
  shake_hands();
  run(1s);
  EXPECT_EQ(sips_.back().flags, 0x1e) << "arrays 1 to 4 on, motors off";
  EXPECT_THAT(sips_.back().sonars, Not(IsEmpty()));
  say("FA FB 06 1C 3B 00 00 1C 3B");
  run(300ms);
  EXPECT_EQ(sips_.back().flags, 0);
  EXPECT_THAT(sips_.back().sonars, IsEmpty());
  say("FA FB 06 1C 3B 01 00 1D 3B");
  run(300ms);
  EXPECT_EQ(sips_.back().flags, 0x1e);
  EXPECT_THAT(sips_.back().sonars, Not(IsEmpty()));
}

TEST_F(PioneerHost, GetsReportsOnceOrWithEachSip) {
  struct Asked {
    Order order;
    std::uint8_t type;
  };
  shake_hands();
  for (const Asked asked : {Asked{Order::kEncoderRequest, 0x90}, Asked{Order::kIoRequest, 0xf0},
                            Asked{Order::kGripperRequest, 0xe0}, Asked{Order::kJoystickRequest, 0xf8}}) {
    SCOPED_TRACE(static_cast<int>(asked.order));
    (void)take_count(asked.type);
    run_with_pulses(1s);
    EXPECT_EQ(take_count(asked.type), 0) << "not asked for";
    say(asked.order, 1);
    run_with_pulses(1s);
    EXPECT_EQ(take_count(asked.type), 1);
    say(asked.order, 2);
    run_with_pulses(1s);
    EXPECT_EQ(take_count(asked.type), 10);
    say(asked.order, 0);
    run_with_pulses(1s);
    EXPECT_EQ(take_count(asked.type), 0);
  }
}

TEST_F(PioneerHost, GetsNoReportOfDevicesThatAPioneerHasNot) {
  shake_hands();
  say("FA FB 06 3E 3B 01 00 3F 3B");  // BATTERYINFO, as hosts send it after CONFIG
  say(Order::kImuRequest, 1);
  say(Order::kGyro, 1);
  run(1s);
  EXPECT_EQ(packets_seen_.size(), sips_.size());
  EXPECT_EQ(robot_.ignored_commands(), 0U) << "known, and nothing to answer";
}

TEST_F(PioneerHost, ReadsEncodersInTicks) {
  open();
  say(Order::kMove, 500);
  run_with_pulses(5s);
  say("FA FB 06 13 3B 01 00 14 3B");
  run(100ms);
  const Bytes report = last(0x90);
  ASSERT_THAT(report, SizeIs(9));
  const int left = report[1] | report[2] << 8 | report[3] << 16 | report[4] << 24;
  EXPECT_NEAR(left, 128 * 1000.0 * left_m(), 1.0);
  EXPECT_NEAR(left, 64000, 400);
}

TEST_F(PioneerHost, SwitchesDigitalOutputsAndSeesThem) {
  shake_hands();
  say(Order::kDigitalOut, 0x0f05);
  say(Order::kDigitalOut, 0x0102);
  say(Order::kAnalogSelect, 3);
  say(Order::kIoRequest, 1);
  run(100ms);
  EXPECT_EQ(sips_.back().digital_out, 0x04) << "bit 0 reset, the others as they were";
  EXPECT_EQ(sips_.back().analog_port, 3);
  EXPECT_EQ(last(0xf0), from_hex("F0 04 30 00 00 FF 01 04 09 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"));
}

TEST_F(PioneerHost, WhoBeginsAnewOverAnOpenConnectionIsLetIn) {
  open();
  run(300ms);
  say("FA FB 03 00 00 00");           // SYNC0 is answered by SIPs
  say("FA FB 06 02 3B 01 00 03 3B");  // so the host closes, twice to be sure
  (void)robot_.take_output();
  say("FA FB 06 02 3B 01 00 03 3B");
  EXPECT_THAT(robot_.take_output(), IsEmpty()) << "no SYNC2";
  say("FA FB 03 00 00 00");
  EXPECT_EQ(robot_.take_output(), from_hex("FA FB 03 00 00 00"));
}

/// The packets of the most common client library for these robots, in its order and rhythm.
TEST_F(PioneerHost, AClientLibraryConfiguresDrivesAndCloses) {
  const auto repeat = [&](Time span, const std::string& packets) {
    for (const Time end = now_ + span; now_ < end;) {
      say(packets);
      run(500ms);
    }
  };
  robot_.connected(now_);
  for (const char* packet :
       {"FA FB 03 00 00 00", "FA FB 03 01 00 01", "FA FB 03 02 00 02", "FA FB 06 01 3B 01 00 02 3B",
        "FA FB 06 12 3B 01 00 13 3B", "FA FB 06 3E 3B 01 00 3F 3B", "FA FB 06 13 3B 02 00 15 3B",
        "FA FB 06 28 3B 02 00 2A 3B", "FA FB 06 06 3B EE 02 F4 3D", "FA FB 06 05 3B 2C 01 31 3C",
        "FA FB 06 05 1B 2C 01 31 1C", "FA FB 06 0A 3B 64 00 6E 3B", "FA FB 06 17 3B 64 00 7B 3B",
        "FA FB 06 17 1B 64 00 7B 1B"}) {
    say(packet);
    run(70ms);
  }
  EXPECT_EQ(take_count(0x20), 1);
  repeat(2s, "FA FB 03 00 00 00");
  EXPECT_EQ(take_count(0x90), 20) << "encoders with each SIP";
  say("FA FB 06 04 3B 01 00 05 3B");         // ENABLE 1
  repeat(2s, "FA FB 06 0B 3B FA 00 05 3B");  // VEL 250
  EXPECT_NEAR(sips_.back().left_mmps, 250, 1);
  EXPECT_EQ(sips_.back().flags, 0x1f);
  repeat(1500ms, "FA FB 06 0B 3B 00 00 0B 3B FA FB 06 15 3B 00 00 15 3B");  // VEL 0, RVEL 0 in one write
  EXPECT_FALSE(sips_.back().moving);
  const double stopped_m = travelled_m();
  say("FA FB 06 08 3B 90 01 98 3C");  // MOVE 400, once
  repeat(4s, "FA FB 03 00 00 00 FA FB 06 15 3B 00 00 15 3B");
  EXPECT_NEAR(travelled_m() - stopped_m, 0.4, 0.005);
  repeat(5s, "FA FB 06 0C 3B 5A 00 66 3B");  // HEAD 90
  EXPECT_NEAR(turned_deg(), 90.0, 0.5);
  repeat(2s, "FA FB 06 20 3B 05 0A 25 45");  // VEL2 200, 100
  EXPECT_NEAR(drive_.left_mps, 0.2, 1e-9);
  EXPECT_NEAR(drive_.right_mps, 0.1, 1e-9);
  say("FA FB 06 04 3B 00 00 04 3B");  // ENABLE 0
  run(200ms);
  EXPECT_EQ(drive_.left_mps, 0.0);
  say("FA FB 06 02 3B 01 00 03 3B");  // CLOSE 1
  EXPECT_FALSE(robot_.is_open());
  EXPECT_EQ(robot_.ignored_commands(), 0U) << "all of it is known";
}

TEST_F(PioneerHost, IsToldWhichCommandsAreNotKnown) {
  shake_hands();
  say(encode(arcos::Command{99, 5}));
  say(encode(arcos::Command{99, 6}));
  EXPECT_THAT(robot_.unknown_commands(), ElementsAre(99));
  EXPECT_EQ(robot_.ignored_commands(), 2U);
}

TEST_F(PioneerHost, IsToldWhichCommandsHaveAWrongArgument) {
  robot_.connected(now_);
  for (const arcos::Bytes& data :
       {arcos::Bytes{1, 0x3b, 1}, arcos::Bytes{18, 0x3b, 1, 0, 0}, arcos::Bytes{18, 0x55, 1}})
    say(arcos::to_packet(data));
  EXPECT_FALSE(robot_.is_open());
  EXPECT_THAT(robot_.malformed_commands(), ElementsAre(1, 18));
  EXPECT_EQ(robot_.ignored_commands(), 3U);
  shake_hands();
  EXPECT_THAT(robot_.malformed_commands(), IsEmpty()) << "another host";
}

}  // namespace
}  // namespace caravan::bridge
