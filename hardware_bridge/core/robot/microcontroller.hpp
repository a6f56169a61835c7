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

/// An emulated Pioneer as it comes out of its box.
struct RobotConfig {
  std::string name = "caravan";
  std::string subtype = "p3dx";
  ArenaPlace arena;
  double compass_offset_rad = 0.0;  ///< how far the compass reads too little
  Point antenna_B;                  ///< of its GPS receiver
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
  double battery_v = 12.6;
  std::uint8_t front_bumpers = 0;  ///< segments; up to arcos::kMostBumpers
  std::uint8_t rear_bumpers = 0;
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
  /// When, by the body's clock: on their way they may be delayed, and then come all at once. None: now.
  std::optional<Time> measured = {};
};

/// What its motors and its gripper do.
struct BodyDrive {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool gripper_closed = false;
};

/// The robot's end of an ARCOS connection: what the microcontroller of a Pioneer 3-DX does with the bytes of
/// a host. docs/arcos.md tells it command by command.
///
/// Sync packets are echoed until OPEN; then a SIP goes out every period, with the sonars that have fired
/// since the one before, one of each array at a time. Motors are off until they are enabled; motion commands
/// that come meanwhile do not count. Without a packet for the watchdog's time the wheels stop; the next
/// motion command moves them again. A host that is lost is noticed by the watchdog alone, as on a serial
/// line, unless the line itself says so (disconnected()). What a host has set is forgotten when its
/// connection ends.
class Microcontroller {
 public:
  /// For so long whoever has the line may send nothing that is a packet, while the connection is not open.
  static constexpr Time kHostPatience = std::chrono::seconds{5};

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

  // The robot's buttons, bumpers and battery.
  void press_stop(bool pressed);
  void switch_motors(bool on);
  /// A bit for each segment that is pressed, the lowest for the first.
  void press_bumpers(unsigned front, unsigned rear);
  void set_battery(double volts) { config_.battery_v = volts; }

  [[nodiscard]] bool is_open() const { return open_; }
  /// Until when a packet must have come, or the line is held by somebody who is no host; none: there is
  /// nobody, or the connection is open.
  [[nodiscard]] std::optional<Time> expects_packet_by() const {
    return connected_ && !open_ ? std::optional{heard_ + kHostPatience} : std::nullopt;
  }
  /// Packets that were no command, and commands that it does not know.
  [[nodiscard]] std::uint64_t ignored_commands() const { return ignored_; }
  /// Numbers of this host's commands that it does not know, each once.
  [[nodiscard]] const std::set<std::uint8_t>& unknown_commands() const { return unknown_; }
  /// Of those whose argument is of no kind or length that ARCOS has.
  [[nodiscard]] const std::set<std::uint8_t>& malformed_commands() const { return malformed_; }

 private:
  void obey(const arcos::Command& command, Time now);
  void shake_hands(const arcos::Command& command, Time now);
  void answer_sync(std::uint8_t number);
  void close();
  // Each: false when the order is none of its kind.
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
  bool synchronised_ = false;  // SYNC2 was the last to be answered
  bool open_ = false;
  bool motors_on_ = false;
  bool stop_pressed_ = false;
  bool stop_stalls_ = true;
  bool sonar_on_ = false;
  bool gripper_closed_ = false;
  unsigned front_bumpers_ = 0;  // that are pressed
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
  std::size_t next_sonar_ = 0;  // of each array
  std::vector<arcos::Sip::Sonar> fired_;
  BodySenses senses_;
  DeadReckoning reckoning_;
  MotionControl motion_;
  MotionControl::Speeds told_;  // what the motors were told last
  StallMonitor left_stall_;
  StallMonitor right_stall_;
  arcos::Bytes output_;
  std::uint64_t ignored_ = 0;
  std::set<std::uint8_t> unknown_;
  std::set<std::uint8_t> malformed_;
};

}  // namespace caravan::bridge
