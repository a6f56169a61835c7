// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Motion limits as set by a host.
struct MotionLimits {
  double speed_mps = 0.75;
  double turn_radps = 1.75;
  double acceleration_mps2 = 0.3;
  double deceleration_mps2 = 0.3;
  double turn_acceleration_radps2 = 1.75;
  double turn_deceleration_radps2 = 1.75;
  double wheel_mps = 1.5;  ///< limit of the motors
};

/// The motion controllers of the microcontroller: convert a host's setpoints into wheel speeds with limited
/// acceleration.
///
/// Translation and rotation are independent. Each has one setpoint, a speed or a position; a new one replaces
/// it. Wheel speeds are converted to translation and rotation, so that the same limits apply. They and the
/// other setpoints replace each other.
class MotionControl {
 public:
  explicit MotionControl(double track_m) : track_m_{track_m} {}

  /// Position on the robot's odometry.
  struct Place {
    double travelled_m = 0.0;  ///< backwards negative
    double yaw_rad = 0.0;
  };

  void set_limits(const MotionLimits& limits) { limits_ = limits; }
  void want_speed(double mps) { want_ahead(mps); }
  void want_distance(double metres, const Place& from) { want_ahead(Until{from.travelled_m + metres}); }
  void want_turn_rate(double radps) { want_turn(radps); }
  void want_heading(double yaw_rad) { want_turn(Until{wrapped(yaw_rad)}); }
  void want_wheels(double left_mps, double right_mps);
  void want_stop();
  /// Sets the speeds to zero at once, without deceleration.
  void halt();
  /// While held, decelerates to zero and stays there; the setpoints remain.
  void hold(bool held) { held_ = held; }
  /// The origin of the odometry's yaw has turned.
  void turn_origin(double by_rad);

  /// The heading setpoint, if there is one.
  [[nodiscard]] std::optional<double> heading_rad() const;
  /// Speed demanded by the setpoint, forward positive.
  [[nodiscard]] double wanted_ahead_mps(const Place& place) const;

  struct Speeds {
    double left_mps = 0.0;
    double right_mps = 0.0;
  };
  [[nodiscard]] Speeds at(Time now, const Place& place);

 private:
  struct Until {
    double value = 0.0;  // travelled_m or yaw_rad
  };
  using Setpoint = std::variant<double, Until>;  // a speed, or a position

  void want_ahead(const Setpoint& setpoint);
  void want_turn(const Setpoint& setpoint);
  [[nodiscard]] double wanted_turn_radps(const Place& place) const;

  double track_m_;
  MotionLimits limits_;
  Setpoint ahead_ = 0.0;
  Setpoint turn_ = 0.0;
  bool by_wheels_ = false;  // both setpoints come from wheel speeds
  bool held_ = false;
  double ahead_mps_ = 0.0;
  double turn_radps_ = 0.0;
  std::optional<Time> last_;
};

}  // namespace caravan::bridge
