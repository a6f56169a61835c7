// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// Commands of a host, with the names and numbers of the ARCOS manual.
enum class Order : std::uint8_t {
  kPulse = 0,            ///< SYNC0 before the connection is open
  kOpen = 1,             ///< SYNC1 before the connection is open
  kClose = 2,            ///< SYNC2 before the connection is open
  kEnable = 4,           ///< motors on (1) or off (0)
  kSetAcceleration = 5,  ///< mm/s2; below 0: deceleration
  kSetMaxSpeed = 6,      ///< mm/s
  kSetOrigin = 7,        ///< sets the odometry to zero
  kMove = 8,             ///< distance in mm; below 0: backwards
  kRotate = 9,           ///< like kTurnRate
  kSetMaxTurnRate = 10,  ///< degrees/s
  kSpeed = 11,           ///< mm/s, both wheels alike
  kHeading = 12,         ///< degrees, in the frame of the odometry
  kHeadingFromHere = 13,
  kJoystickRequest = 17,  ///< this and the other requests: 1 once, above 1 with each SIP, 0 never
  kConfig = 18,           ///< requests the robot's Settings
  kEncoderRequest = 19,
  kTurnRate = 21,             ///< degrees/s, counter-clockwise
  kHeadingFromSetpoint = 22,  ///< degrees, from the last heading setpoint
  kSetTurnAcceleration = 23,  ///< degrees/s2; below 0: deceleration
  kImuRequest = 26,
  kSonar = 28,
  kStop = 29,
  kDigitalOut = 30,   ///< high byte: mask; low byte: values
  kWheelSpeeds = 32,  ///< low byte right, high byte left, signed, 20 mm/s each
  kGripper = 33,      ///< 1 opens, 2 closes
  kAnalogSelect = 35,
  kGripperRequest = 37,
  kIoRequest = 40,
  kBumpStall = 44,   ///< bumpers that stop the robot: 0 none, 1 front, 2 rear, 3 both
  kSonarCycle = 48,  ///< ms between two transducers of an array
  kHostBaud = 50,
  kEmergencyStop = 55,
  kStopButtonStalls = 56,  ///< whether the stop button is reported as a stall: 0 no, 1 yes
  kGyro = 58,
  kBatteryRequest = 62,
  kTurnGainP = 82,  ///< this and the following: fields of Settings
  kTurnGainV = 83,
  kTurnGainI = 84,
  kSpeedGainP = 85,
  kSpeedGainV = 86,
  kSpeedGainI = 87,
  kTicksPerTurn = 88,
  kDriftFactor = 89,
  kTicksPerMm = 93,
};

inline constexpr int kGripperOpens = 1;
inline constexpr int kGripperCloses = 2;

/// Argument of a request for reports: how often to send it.
inline constexpr int kNoReport = 0;
inline constexpr int kOneReport = 1;  ///< above 1: with each SIP

/// One command packet. `number` may be unknown to Order.
struct Command {
  std::uint8_t number = 0;
  std::variant<std::monostate, int, std::string> argument;  ///< an int is within +-65535
  bool operator==(const Command&) const = default;
};

[[nodiscard]] Bytes encode(const Command& command);
[[nodiscard]] Bytes encode(Order order);
[[nodiscard]] Bytes encode(Order order, int argument);

/// The integer argument of a command; 0 when it has none, or a text.
[[nodiscard]] int number_of(const Command& command);

/// Decodes a packet's data, with any kind of argument; none when it is not a command.
[[nodiscard]] std::optional<Command> decode_command(std::span<const std::uint8_t> data);

/// Argument of kWheelSpeeds: speeds rounded to 20 mm/s and limited to 126 units.
/// @pre both finite
[[nodiscard]] int wheel_speeds_argument(double left_mps, double right_mps);

struct WheelSpeeds {
  int left_mmps = 0;
  int right_mmps = 0;
  bool operator==(const WheelSpeeds&) const = default;
};
[[nodiscard]] WheelSpeeds wheel_speeds_of(int argument);

}  // namespace caravan::bridge::arcos
