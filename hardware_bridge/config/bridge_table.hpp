// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"
#include "runtime/config/toml_table.hpp"

namespace caravan::bridge {

/// `[bridge]`: the arena's place on earth, and the parameters of a bridged Pioneer. Every key is optional,
/// unknown keys are refused.
struct BridgeTable {
  double origin_latitude_deg = 0.0;  ///< of frame W's origin
  double origin_longitude_deg = 0.0;
  double x_axis_rad = 0.0;            ///< direction of W's x axis, counter-clockwise from east
  bool has_compass = true;            ///< false: the yaw starts at start_yaw_rad
  double compass_offset_rad = 0.0;    ///< added to the compass reading, clockwise: declination and mounting
  std::array<double, 2> antenna_m{};  ///< position of the GPS antenna: x forward, y left
  std::array<double, 2> start_m{};    ///< initial position; used without GPS
  double start_yaw_rad = 0.0;         ///< initial yaw; used without compass
  double gps_trust = 0.3;
  double compass_trust = 0.1;
  double gps_timeout_s = 0.4;      ///< after this time without a fix the wheels stop
  double gps_jump_m = 5.0;         ///< a fix farther off is refused until several agree
  double command_timeout_s = 0.6;  ///< after this time without a command the wheels are at rest
  double position_count_m = 0.0;   ///< metres per count of the odometry; 0: from the subtype
  double silence_s = 0.4;          ///< after this time without a SIP the robot is told to stop
  double acceleration_mps2 = 2.0;
  double low_battery_v = 11.5;
  bool has_gripper = true;  ///< false: simulated by position
  double watchdog_s = 2.0;  ///< of an emulated robot
};

/// @throws StartError `file:line: key: reason`
[[nodiscard]] BridgeTable read_bridge(const runtime::TomlDocument& scenario);

/// Settings of the programs, from `[bridge]`, `[robots]` and the command line. @param has_gps  a receiver is
/// connected
[[nodiscard]] BridgeConfig load_bridge_config(const runtime::TomlDocument& scenario, bool has_gps);
[[nodiscard]] RobotConfig load_robot_config(const runtime::TomlDocument& scenario, std::uint32_t robot);

}  // namespace caravan::bridge
