// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// The robot's server information packet as it stands on the line: raw counts, nothing converted. It carries
/// only the sonar readings that are new.
struct Sip {
  struct Sonar {
    std::uint8_t index = 0;
    std::uint16_t range_mm = 0;  ///< kNoEcho_mm or more: none
    bool operator==(const Sonar&) const = default;
  };

  bool moving = false;
  std::uint16_t x = 0;  ///< of the odometry; its lower 15 bits wrap
  std::uint16_t y = 0;
  std::int16_t heading = 0;  ///< 4096 to the turn
  std::int16_t left_mmps = 0;
  std::int16_t right_mmps = 0;
  std::uint8_t battery_dv = 0;  ///< tenths of a volt
  std::uint16_t stall_and_bumpers = 0;
  std::int16_t control = 0;
  std::uint16_t flags = 0;
  std::uint8_t compass = 0;  ///< 2 degrees, clockwise from north
  std::vector<Sonar> sonars;
  // Later fields, each there only when the ones before it are.
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
inline constexpr std::uint16_t kSonarsOn = 0xfU << 1U;   ///< in flags: a bit for each array
inline constexpr std::uint16_t kStopPressed = 1U << 5U;  ///< in flags: the emergency stop button
inline constexpr std::uint16_t kStopStalls = 1U << 6U;   ///< in flags: it is shown as a stall, too
inline constexpr std::uint16_t kLeftStall = 1U << 0U;    ///< in stall_and_bumpers
inline constexpr std::uint16_t kRightStall = 1U << 8U;
/// In stall_and_bumpers: a bit for each segment that is pressed. The rear ones are in the low byte.
inline constexpr unsigned kFrontBumperShift = 9;
inline constexpr unsigned kRearBumperShift = 1;
inline constexpr unsigned kMostBumpers = 7;  ///< front, and as many rear

/// In digital_in, for a gripper on the user I/O port; a paddle's bit is 0 while something presses on it.
inline constexpr std::uint8_t kGripperNotOpen = 1U << 0U;
inline constexpr std::uint8_t kInnerBeamBroken = 1U << 3U;
inline constexpr std::uint8_t kLeftPaddleFree = 1U << 4U;
inline constexpr std::uint8_t kRightPaddleFree = 1U << 5U;

/// @return the packet's data; at most so many sonar readings as fit
[[nodiscard]] Bytes encode(const Sip& sip);
/// Empty when the data is no SIP or a torn one. Fields that this program does not know may follow.
[[nodiscard]] std::optional<Sip> decode_sip(std::span<const std::uint8_t> data);

/// What the robot says of itself when a host opens a connection.
struct Names {
  std::string name;
  std::string type;     ///< "Pioneer"
  std::string subtype;  ///< "p3dx", "p3dx-sh"
  bool operator==(const Names&) const = default;
};
/// The data of the answer to SYNC2.
[[nodiscard]] Bytes encode(const Names& names);
[[nodiscard]] std::optional<Names> decode_names(std::span<const std::uint8_t> data);

}  // namespace caravan::bridge::arcos
