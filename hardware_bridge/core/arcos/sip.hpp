// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// The robot's server information packet (SIP), in raw counts as transmitted. Contains only new sonar
/// readings.
struct Sip {
  struct Sonar {
    std::uint8_t index = 0;
    std::uint16_t range_mm = 0;  ///< kNoEcho_mm or more: no echo
    bool operator==(const Sonar&) const = default;
  };

  bool moving = false;
  std::uint16_t x = 0;  ///< odometry; the lower 15 bits count and wrap
  std::uint16_t y = 0;
  std::int16_t heading = 0;  ///< 4096 per turn
  std::int16_t left_mmps = 0;
  std::int16_t right_mmps = 0;
  std::uint8_t battery_dv = 0;  ///< tenths of a volt
  std::uint16_t stall_and_bumpers = 0;
  std::int16_t control = 0;
  std::uint16_t flags = 0;
  std::uint8_t compass = 0;  ///< units of 2 degrees, clockwise from north
  std::vector<Sonar> sonars;
  // Later fields: each is present only if those before it are.
  std::optional<std::uint8_t> gripper;
  std::optional<std::uint8_t> analog_port;
  std::optional<std::uint8_t> analog;
  std::optional<std::uint8_t> digital_in;
  std::optional<std::uint8_t> digital_out;
  std::optional<std::uint16_t> battery_fine_dv;
  std::optional<std::uint8_t> charge;
  std::optional<std::int16_t> turn_rate;
  std::optional<std::uint16_t> fault;
  bool operator==(const Sip&) const = default;
};

inline constexpr std::uint16_t kNoEcho_mm = 5000;
inline constexpr std::uint16_t kMotorsOn = 1U << 0U;     ///< in flags
inline constexpr std::uint16_t kSonarsOn = 0xfU << 1U;   ///< in flags: one bit per array
inline constexpr std::uint16_t kStopPressed = 1U << 5U;  ///< in flags: emergency stop button
inline constexpr std::uint16_t kStopStalls = 1U << 6U;   ///< in flags: the button is also reported as a stall
inline constexpr std::uint16_t kLeftStall = 1U << 0U;    ///< in stall_and_bumpers
inline constexpr std::uint16_t kRightStall = 1U << 8U;
/// In stall_and_bumpers: one bit per pressed segment; the rear ones are in the low byte.
inline constexpr unsigned kFrontBumperShift = 9;
inline constexpr unsigned kRearBumperShift = 1;
inline constexpr unsigned kMostBumpers = 7;  ///< number of front segments, and of rear ones

/// In digital_in, for a gripper on the user I/O port. A paddle's bit is 0 while something presses on it.
inline constexpr std::uint8_t kGripperNotOpen = 1U << 0U;
inline constexpr std::uint8_t kInnerBeamBroken = 1U << 3U;
inline constexpr std::uint8_t kLeftPaddleFree = 1U << 4U;
inline constexpr std::uint8_t kRightPaddleFree = 1U << 5U;

/// @return the packet's data, with at most as many sonar readings as fit
[[nodiscard]] Bytes encode(const Sip& sip);
/// None when the data is not a SIP, or incomplete. Unknown fields may follow.
[[nodiscard]] std::optional<Sip> decode_sip(std::span<const std::uint8_t> data);

/// What the robot reports about itself when a host connects.
struct Names {
  std::string name;
  std::string type;     ///< "Pioneer"
  std::string subtype;  ///< "p3dx", "p3dx-sh"
  bool operator==(const Names&) const = default;
};
/// Data of the answer to SYNC2.
[[nodiscard]] Bytes encode(const Names& names);
[[nodiscard]] std::optional<Names> decode_names(std::span<const std::uint8_t> data);

}  // namespace caravan::bridge::arcos
