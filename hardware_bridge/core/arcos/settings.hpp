// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// The answer to CONFIG: construction and settings of the robot. Defaults are those of a Pioneer 3-DX as
/// delivered. Fields are in the order of the packet.
struct Settings {
  std::string type = "Pioneer";
  std::string subtype = "p3dx";  ///< or "p3dx-sh"
  std::string serial_number;
  std::uint8_t four_motors = 0;
  std::uint16_t top_turn_degps = 360;  ///< this and the other top_ fields: upper limits of what can be set
  std::uint16_t top_speed_mmps = 1500;
  std::uint16_t top_turn_acceleration_degps2 = 600;
  std::uint16_t top_acceleration_mmps2 = 4000;
  std::uint16_t top_pulse_width = 500;
  std::string name;
  std::uint8_t sip_period_ms = 100;
  std::uint8_t host_baud = 0;  ///< 0 to 4: 9600, 19200, 38400, 57600, 115200
  std::uint8_t auxiliary_baud = 0;
  std::uint16_t gripper = 0;
  std::uint16_t front_sonar = 1;
  std::uint8_t rear_sonar = 1;
  std::uint16_t low_battery_dv = 110;  ///< tenths of a volt
  std::uint16_t ticks_per_turn = 16570;
  std::uint16_t watchdog_ms = 2000;  ///< wheels stop after this time without a packet; 0: never

  // Older firmware ends at one of the following fields.
  std::uint8_t alternative_sip = 0;
  std::uint16_t stall_pulse_width = 200;
  std::uint16_t stall_ms = 100;
  std::uint16_t joystick_speed_mmps = 0;
  std::uint16_t joystick_turn_degps = 0;
  std::uint16_t max_turn_degps = 100;  ///< this and the following fields: as currently set
  std::uint16_t max_speed_mmps = 750;
  std::uint16_t turn_acceleration_degps2 = 100;
  std::uint16_t turn_deceleration_degps2 = 100;
  std::uint16_t turn_gain_p = 40;
  std::uint16_t turn_gain_v = 20;
  std::uint16_t turn_gain_i = 0;
  std::uint16_t acceleration_mmps2 = 300;
  std::uint16_t deceleration_mmps2 = 300;
  std::uint16_t speed_gain_p = 40;
  std::uint16_t speed_gain_v = 20;
  std::uint16_t speed_gain_i = 0;
  std::uint8_t front_bumpers = 0;
  std::uint8_t rear_bumpers = 0;
  std::uint8_t charger = 0;
  std::uint8_t sonar_cycle_ms = 40;
  std::uint8_t automatic_baud = 2;  ///< 2: the rate can be changed
  std::uint8_t gyro = 0;
  std::int16_t drift_factor = 0;  ///< units of 1/8192
  std::uint8_t auxiliary_2_baud = 0;
  std::uint8_t auxiliary_3_baud = 0;
  std::uint16_t ticks_per_mm = 128;
  std::uint16_t shutdown_dv = 0;
  std::string firmware;  ///< such as "2.9"
  std::uint16_t gyro_clockwise = 0;
  std::uint16_t gyro_counter_clockwise = 0;
  std::uint8_t kinematics_delay_ms = 0;
  std::uint16_t top_sideways_mmps = 0;
  std::uint16_t top_sideways_acceleration_mmps2 = 0;
  std::uint16_t max_sideways_mmps = 0;
  std::uint16_t sideways_acceleration_mmps2 = 0;
  std::uint16_t sideways_deceleration_mmps2 = 0;
  std::uint16_t charge_threshold_dv = 0;
  bool operator==(const Settings&) const = default;
};

/// The packet's data.
[[nodiscard]] Bytes encode(const Settings& settings);
/// None when the data is no such packet, or ends before the watchdog. Fields that an older robot does not
/// send are 0.
[[nodiscard]] std::optional<Settings> decode_settings(std::span<const std::uint8_t> data);

}  // namespace caravan::bridge::arcos
