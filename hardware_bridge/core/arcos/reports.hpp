// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hardware_bridge/core/arcos/packet.hpp"

/// The packets other than SIPs that a robot sends on request.
namespace caravan::bridge::arcos {

/// Distance that each wheel has turned since the robot was switched on, in ticks; wraps.
struct EncoderReport {
  std::int32_t left_ticks = 0;
  std::int32_t right_ticks = 0;
};

/// The robot's inputs and outputs.
struct IoReport {
  std::uint8_t digital_in = 0;
  std::uint8_t front_bumpers = 0;  ///< one bit per segment
  std::uint8_t rear_bumpers = 0;
  std::uint8_t infrared = 0xff;  ///< one bit per sensor, 0: detects something
  std::uint8_t digital_out = 0;
  std::array<std::uint16_t, 9> analog{};  ///< 0 to 1023
};

struct GripperReport {
  std::uint8_t type = 1;  ///< 0 none, 1 on the user I/O port
  std::uint8_t state = 0;
  std::uint8_t grasp_time = 0;  ///< units of 20 ms
};

/// A joystick on the robot's own port; the centre of an axis is 512.
struct JoystickReport {
  std::uint8_t button_1 = 0;
  std::uint8_t button_2 = 0;
  std::uint16_t x = 512;
  std::uint16_t y = 512;
  std::uint16_t throttle = 0;
};

/// Bits of the gripper's state, in SIP and GripperReport.
inline constexpr std::uint8_t kPaddlesOpen = 1U << 0U;
inline constexpr std::uint8_t kPaddlesClosed = 1U << 1U;

/// The packet's data.
[[nodiscard]] Bytes encode(const EncoderReport& report);
[[nodiscard]] Bytes encode(const IoReport& report);
[[nodiscard]] Bytes encode(const GripperReport& report);
[[nodiscard]] Bytes encode(const JoystickReport& report);

}  // namespace caravan::bridge::arcos
