// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// What a robot answers to CONFIG: how it is built and set up. The packet goes on after the watchdog with
/// what no host of ours asks for.
struct Settings {
  std::string type;     ///< "Pioneer"
  std::string subtype;  ///< "p3dx", "p3dx-sh"
  std::string serial_number;
  std::uint8_t four_motors = 0;
  std::uint16_t top_turn_degps = 0;
  std::uint16_t top_speed_mmps = 0;
  std::uint16_t top_turn_acceleration_degps2 = 0;
  std::uint16_t top_acceleration_mmps2 = 0;
  std::uint16_t top_pulse_width = 0;
  std::string name;
  std::uint8_t sip_period_ms = 0;
  std::uint8_t host_baud = 0;  ///< 0 to 4: 9600, 19200, 38400, 57600, 115200
  std::uint8_t auxiliary_baud = 0;
  std::uint16_t gripper = 0;
  std::uint16_t front_sonar = 0;
  std::uint8_t rear_sonar = 0;
  std::uint16_t low_battery_dv = 0;  ///< tenths of a volt
  std::uint16_t ticks_per_turn = 0;
  std::uint16_t watchdog_ms = 0;  ///< without a packet for so long, wheels at zero; 0: never
  bool operator==(const Settings&) const = default;
};

/// The packet's data.
[[nodiscard]] Bytes encode(const Settings& settings);
/// Empty when the data is no such packet or a torn one.
[[nodiscard]] std::optional<Settings> decode_settings(std::span<const std::uint8_t> data);

}  // namespace caravan::bridge::arcos
