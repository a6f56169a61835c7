// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/robot/dead_reckoning.hpp"
#include "hardware_bridge/core/robot/wheel_ramp.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// An emulated Pioneer as it comes out of its box.
struct RobotConfig {
  std::string name = "caravan";
  std::string subtype = "p3dx";
  ArenaPlace arena;
  double compass_offset_rad = 0.0;  ///< how far the compass reads too little
  double track_m = 0.330;
  double wheel_radius_m = 0.0975;
  double battery_v = 12.6;
  Time sip_period = std::chrono::milliseconds{100};
  Time sonar_period = std::chrono::milliseconds{40};  ///< between two transducers of an array
  Time watchdog = std::chrono::milliseconds{2000};    ///< without a packet for so long, wheels at zero
};

/// What the robot's devices measure now.
struct BodySenses {
  std::array<double, kSonarCount> sonar_range_m{};  ///< +inf: no echo
  double yaw_WB_rad = 0.0;                          ///< for the compass
  double left_wheel_rad = 0.0;
  double right_wheel_rad = 0.0;
  bool holding = false;
};

/// What its motors and its gripper do.
struct BodyDrive {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool gripper_closed = false;
};

/// The robot's end of an ARCOS connection: what the microcontroller of a Pioneer 3-DX does with the bytes of
/// a host.
///
/// Sync packets are echoed until OPEN; then a SIP goes out every period, with the sonars that have fired
/// since the one before, one of each array at a time. Motors are off until they are enabled. Without a packet
/// for the watchdog's time the wheels stop; the next motion command moves them again. A host that is lost is
/// noticed by the watchdog alone, as on a serial line, unless the line itself says so (disconnected()).
class Microcontroller {
 public:
  explicit Microcontroller(const RobotConfig& config);

  /// A host's line is there, or gone: the connection is not open, the motors are off.
  void connected(Time now);
  void disconnected();
  void receive(std::span<const std::uint8_t> bytes, Time now);
  void sense(const BodySenses& senses, Time now);
  /// Sends SIPs that are due, fires sonars, keeps the watchdog.
  void tick(Time now);
  [[nodiscard]] Time next_deadline() const { return sip_due_; }
  /// What motors and gripper do from now on. To be asked regularly: speeds change by ramps.
  [[nodiscard]] BodyDrive drive(Time now);
  /// What goes to the host, once.
  [[nodiscard]] arcos::Bytes take_output();

  // The robot's buttons and battery.
  void press_stop(bool pressed);
  void switch_motors(bool on);
  void set_battery(double volts) { config_.battery_v = volts; }

  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] std::uint64_t ignored_commands() const { return ignored_; }

 private:
  void obey(const arcos::Command& command, Time now);
  void obey_number(arcos::Order order, const arcos::Command& command);
  void answer_sync(std::uint8_t number);
  [[nodiscard]] arcos::Settings settings() const;
  void send(std::span<const std::uint8_t> data);
  void send_sip(Time now);
  void fire_sonars(Time now);
  [[nodiscard]] std::uint8_t digital_in() const;

  RobotConfig config_;
  ArenaProjection projection_;
  arcos::PacketFinder packets_;
  bool connected_ = false;
  bool synchronised_ = false;  // SYNC2 was the last to be answered
  bool open_ = false;
  bool motors_on_ = false;
  bool stop_pressed_ = false;
  bool sonar_on_ = false;
  bool gripper_closed_ = false;
  Time heard_{0};
  Time sip_due_{0};
  Time sonar_due_{0};
  std::size_t next_sonar_ = 0;  // of each array
  std::vector<arcos::Sip::Sonar> fired_;
  BodySenses senses_;
  DeadReckoning reckoning_;
  WheelRamp ramp_;
  arcos::Bytes output_;
  std::uint64_t ignored_ = 0;
};

}  // namespace caravan::bridge
