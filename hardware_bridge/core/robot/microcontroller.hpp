// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/robot/dead_reckoning.hpp"
#include "hardware_bridge/core/robot/motion_control.hpp"
#include "hardware_bridge/core/robot/report_request.hpp"
#include "hardware_bridge/core/robot/stall_monitor.hpp"
#include "hardware_bridge/core/values.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::bridge {

/// An emulated Pioneer with its default settings.
struct RobotConfig {
  std::string name = "caravan";
  std::string subtype = "p3dx";
  ArenaPlace arena;
  double compass_offset_rad = 0.0;  ///< the compass reads too low by this
  Point antenna_B;                  ///< position of its GPS antenna
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
  double battery_v = 12.6;
  std::uint8_t front_bumpers = 0;  ///< number of segments, at most arcos::kMostBumpers
  std::uint8_t rear_bumpers = 0;
  Time sip_period = std::chrono::milliseconds{100};
  Time sonar_period = std::chrono::milliseconds{40};  ///< between two transducers of an array
  Time watchdog = std::chrono::milliseconds{2000};    ///< after this time without a packet the wheels stop
};

/// Current measurements of the robot's devices.
struct BodySenses {
  std::array<double, kSonarCount> sonar_range_m{};  ///< +inf: no echo
  double yaw_WB_rad = 0.0;                          ///< for the compass
  double left_wheel_rad = 0.0;
  double right_wheel_rad = 0.0;
  bool holding = false;
  /// Time of measurement by the body's clock: frames may be delayed and arrive together. None: now.
  std::optional<Time> measured = {};
};

/// Commands to its motors and its gripper.
struct BodyDrive {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool gripper_closed = false;
};

/// The robot's end of an ARCOS connection: emulates the microcontroller of a Pioneer 3-DX. docs/arcos.md
/// describes each command.
///
/// Sync packets are echoed until OPEN. Then a SIP is sent every period, with the sonars that have fired since
/// the previous one; in each array one sonar fires at a time. Motors are off until they are enabled; motion
/// commands that arrive before are ignored. Without a packet for RobotConfig::watchdog the wheels stop; with
/// the next packet of any kind the robot resumes its last command. As on a serial line only the watchdog
/// detects a lost host, unless the line itself reports it (disconnected()). The settings of a host are
/// discarded when its connection ends.
class Microcontroller {
 public:
  /// How long a client may send no valid packet while the connection is not open.
  static constexpr Time kHostPatience = std::chrono::seconds{5};

  explicit Microcontroller(const RobotConfig& config);

  /// A host's line is up or down. The connection is not open then, and the motors are off.
  void connected(Time now);
  void disconnected();
  void receive(std::span<const std::uint8_t> bytes, Time now);
  void sense(const BodySenses& senses, Time now);
  /// Sends SIPs that are due, fires sonars, checks the watchdog.
  void tick(Time now);
  [[nodiscard]] Time next_deadline() const { return sip_due_; }
  /// Commands to motors and gripper from now on. Call regularly: speeds change by ramps.
  [[nodiscard]] BodyDrive drive(Time now);
  /// Bytes for the host; empties the queue.
  [[nodiscard]] arcos::Bytes take_output();

  // Buttons, bumpers and battery of the robot.
  void press_stop(bool pressed);
  void switch_motors(bool on);
  /// One bit per pressed segment, the lowest for the first.
  void press_bumpers(unsigned front, unsigned rear);
  void set_battery(double volts) { config_.battery_v = volts; }

  [[nodiscard]] bool is_open() const { return open_; }
  /// Deadline for a packet while the connection is not open: a client that misses it is not a host. None: no
  /// client, or the connection is open.
  [[nodiscard]] std::optional<Time> expects_packet_by() const {
    return connected_ && !open_ ? std::optional{heard_ + kHostPatience} : std::nullopt;
  }
  /// Number of packets that were not a command, and of unknown commands.
  [[nodiscard]] std::uint64_t ignored_commands() const { return ignored_; }
  /// Numbers of unknown commands of this host.
  [[nodiscard]] const std::set<std::uint8_t>& unknown_commands() const { return unknown_; }
  /// Numbers of commands whose argument has a type or length that ARCOS does not define.
  [[nodiscard]] const std::set<std::uint8_t>& malformed_commands() const { return malformed_; }

 private:
  void obey(const arcos::Command& command, Time now);
  void shake_hands(const arcos::Command& command, Time now);
  void answer_sync(std::uint8_t number);
  void close();
  // Each returns false when the order is of another kind.
  [[nodiscard]] bool move(arcos::Order order, int value);
  [[nodiscard]] bool switch_on_or_off(arcos::Order order, int value);
  [[nodiscard]] bool ask_for_report(arcos::Order order, int value);
  [[nodiscard]] MotionControl::Place place() const {
    return {reckoning_.travelled_m(), reckoning_.yaw_rad()};
  }
  void stop_at_bumpers();

  void send(std::span<const std::uint8_t> data);
  void send_sip(Time now);
  void send_with_sip(Time now);
  void fire_sonars(Time now);
  [[nodiscard]] std::uint16_t stall_and_bumpers(Time now) const;
  [[nodiscard]] std::uint16_t flags() const;
  [[nodiscard]] std::uint8_t compass() const;
  [[nodiscard]] std::uint8_t digital_in() const;
  [[nodiscard]] std::uint8_t gripper_state() const;

  RobotConfig config_;
  ArenaProjection projection_;
  arcos::Settings settings_;
  arcos::PacketFinder packets_;
  bool connected_ = false;
  bool synchronised_ = false;  // the last sync answered was SYNC2
  bool open_ = false;
  bool motors_on_ = false;
  bool stop_pressed_ = false;
  bool stop_stalls_ = true;
  bool sonar_on_ = false;
  bool gripper_closed_ = false;
  unsigned front_bumpers_ = 0;  // pressed
  unsigned rear_bumpers_ = 0;
  int bump_stall_ = 3;  // argument of BUMPSTALL
  bool bump_stalled_ = false;
  unsigned digital_out_ = 0;
  std::uint8_t analog_port_ = 0;
  ReportRequest encoders_asked_;
  ReportRequest io_asked_;
  ReportRequest gripper_asked_;
  ReportRequest joystick_asked_;
  Time heard_{0};
  Time sip_due_{0};
  Time sonar_due_{0};
  std::size_t next_sonar_ = 0;  // index in each array
  std::vector<arcos::Sip::Sonar> fired_;
  BodySenses senses_;
  DeadReckoning reckoning_;
  MotionControl motion_;
  MotionControl::Speeds told_;  // last command to the motors
  StallMonitor left_stall_;
  StallMonitor right_stall_;
  arcos::Bytes output_;
  std::uint64_t ignored_ = 0;
  std::set<std::uint8_t> unknown_;
  std::set<std::uint8_t> malformed_;
};

}  // namespace caravan::bridge
