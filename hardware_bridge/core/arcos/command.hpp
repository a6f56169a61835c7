// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// What a host asks of the robot, by the numbers of the ARCOS manual.
enum class Order : std::uint8_t {
  kPulse = 0,            ///< also SYNC0, before the connection is open
  kOpen = 1,             ///< also SYNC1
  kClose = 2,            ///< also SYNC2
  kEnable = 4,           ///< motors on (1) or off (0)
  kSetAcceleration = 5,  ///< mm/s2; below 0: deceleration
  kSetMaxSpeed = 6,      ///< mm/s
  kSetOrigin = 7,        ///< odometry to zero
  kSpeed = 11,           ///< mm/s, straight
  kHeading = 12,         ///< degrees, of the odometry
  kConfig = 18,          ///< asks for the robot's Settings
  kTurnRate = 21,        ///< degrees a second, counter-clockwise
  kSonar = 28,
  kStop = 29,
  kWheelSpeeds = 32,  ///< low byte right, high byte left, signed, 20 mm/s each
  kGripper = 33,      ///< 1 opens, 2 closes
  kIoRequest = 40,
  kBumpStall = 44,
  kHostBaud = 50,
  kEmergencyStop = 55,
};

inline constexpr int kGripperOpens = 1;
inline constexpr int kGripperCloses = 2;

/// One command packet. The number may be one that Order does not name.
struct Command {
  std::uint8_t number = 0;
  std::variant<std::monostate, int, std::string> argument;  ///< an int is within +-65535
  bool operator==(const Command&) const = default;
};

[[nodiscard]] Bytes encode(const Command& command);
[[nodiscard]] Bytes encode(Order order);
[[nodiscard]] Bytes encode(Order order, int argument);

/// What a packet's data asks for; empty when it is no command.
[[nodiscard]] std::optional<Command> decode_command(std::span<const std::uint8_t> data);

/// Argument of kWheelSpeeds: the nearest multiples of 20 mm/s, within +-126 of them. @pre both finite
[[nodiscard]] int wheel_speeds_argument(double left_mps, double right_mps);

struct WheelSpeeds {
  int left_mmps = 0;
  int right_mmps = 0;
  bool operator==(const WheelSpeeds&) const = default;
};
[[nodiscard]] WheelSpeeds wheel_speeds_of(int argument);

}  // namespace caravan::bridge::arcos
