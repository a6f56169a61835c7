// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/sonar_memory.hpp"
#include "hardware_bridge/core/host/gps_source.hpp"
#include "hardware_bridge/core/host/gripper.hpp"
#include "hardware_bridge/core/host/health_monitor.hpp"
#include "hardware_bridge/core/host/robot_link.hpp"
#include "hardware_bridge/core/host/sonar_watch.hpp"
#include "hardware_bridge/core/host/stop_latch.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/pose/pose_fusion.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::bridge {

struct BridgeConfig {
  LinkConfig link;
  FusionConfig fusion;
  ArenaPlace arena;
  double gps_jump_m = 5.0;          ///< a fix farther than this from the expected place is an outlier
  double compass_offset_rad = 0.0;  ///< added to the compass reading, clockwise
  Time command_timeout = std::chrono::milliseconds{600};  ///< longest time without a command; then at rest
  std::optional<double> position_count_m;                 ///< scale of the odometry; none: from the subtype
  double low_battery_v = 11.5;
  bool has_gripper = true;  ///< false: simulated by position
  Point source_W;           ///< for a simulated gripper
  double service_radius_m = 1.5;
  double wheel_limit_mps = robot_model::kWheelLimit_mps;
  double track_m = robot_model::kTrack_m;
  double wheel_radius_m = robot_model::kWheelRadius_m;
};

/// The sensor values for the agent, one frame per SIP. NaN: the value is unknown.
struct Frame {
  Time stamp{0};
  std::array<double, kSonarCount> sonar_range_m{};
  std::array<double, kSonarCount> sonar_age_s{};
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
  double left_wheel_rad = 0.0;  ///< since the bridge started
  double right_wheel_rad = 0.0;
  bool holding = false;
};

/// A command of the agent.
struct Wish {
  double left_mps = 0.0;  ///< rim speeds
  double right_mps = 0.0;
  bool gripper_closed = false;
};

/// The bridge between an agent and a Pioneer as a function of values, without ports, topics and clocks:
/// receives bytes and commands, returns bytes and frames.
///
/// Wheels turn only under these conditions: the last command is younger than the command timeout less the
/// braking time; the robot is heard and receives; its pose is known; no emergency stop is latched. When a
/// condition ends, the wheels are told to stop at once, and again every half second.
class Bridge {
 public:
  explicit Bridge(const BridgeConfig& config);

  void robot_up(Time now);
  void robot_down(Time now);
  void robot_says(std::span<const std::uint8_t> bytes, Time now);
  void gps_says(std::span<const std::uint8_t> bytes, Time now);
  void gps_down() { gps_.restart(); }
  /// @param answers  stamp of the frame that it answers; ignored when this is older than the command timeout
  void wish(const Wish& wish, Time answers, Time now);
  /// Forgets the last command: the agent has left.
  void forget_wish(Time now);
  void tick(Time now);
  /// Latest time for the next tick().
  [[nodiscard]] Time next_deadline(Time now) const;
  /// Stops the wheels and closes the connection, at the end of the program.
  void close() { link_.close(); }

  struct Effects {
    arcos::Bytes to_robot;
    std::vector<Frame> frames;
    std::vector<Notice> notices;
    bool reopen_robot = false;  ///< close the line and reopen it, at the next baud rate if it is serial
    std::string unfit;          ///< why this robot cannot be driven at all; empty: it can
  };
  /// Effects of all calls since the previous take_effects().
  [[nodiscard]] Effects take_effects();

  [[nodiscard]] bool may_move(Time now) const;
  [[nodiscard]] std::uint64_t refused_wishes() const { return refused_; }
  [[nodiscard]] std::uint64_t clamped_wishes() const { return clamped_; }
  [[nodiscard]] std::uint64_t stale_wishes() const { return stale_; }

 private:
  void on_sip(const arcos::Sip& sip, Time now);
  void follow(const arcos::Sip& sip, Time now);
  [[nodiscard]] bool know_scale();
  [[nodiscard]] arcos::Moved plausible(const arcos::Moved& moved, Time now);
  void see_stop(const arcos::Sip& sip);
  void publish(Time now);
  void grip(bool closed, Time now);
  [[nodiscard]] Wish safe(const Wish& wish);
  void note(Notice::Weight weight, std::string text, std::string about = {}) {
    effects_.notices.push_back({weight, std::move(text), std::move(about)});
  }
  [[nodiscard]] bool is_wished(Time now) const;
  void keep_still(Time now);
  void tell_of_missing_commands();
  void tell_safety(Time now);
  void tell_position(Time now);
  void tell_what_is_awaited(Time now);

  BridgeConfig config_;
  RobotLink link_;
  HealthMonitor health_;
  SonarWatch sonar_watch_;
  StopLatch latch_;
  GpsSource gps_;
  ArenaProjection projection_;
  PoseFusion fusion_;
  arcos::SonarMemory sonars_;
  std::optional<arcos::Odometry> odometry_;
  std::variant<ArcosGripper, ImaginedGripper> gripper_;
  double left_wheel_rad_ = 0.0;
  double right_wheel_rad_ = 0.0;
  Time last_stamp_{-1};
  std::optional<Time> wished_;  // time of the last command
  Wish wish_;
  bool moved_ = false;             // allowed to move at the last check
  bool stopped_unwished_ = false;  // stopped because commands are missing, not reported yet
  Time stop_due_{0};
  std::optional<Time> tell_due_;  // when to report what is awaited; none: not checked yet
  bool was_heard_ = false;
  bool was_safe_ = true;
  std::optional<Time> followed_;  // time of the previous SIP
  bool had_position_ = false;
  std::uint64_t refused_ = 0;
  std::uint64_t clamped_ = 0;
  std::uint64_t stale_ = 0;
  Effects effects_;
};

}  // namespace caravan::bridge
