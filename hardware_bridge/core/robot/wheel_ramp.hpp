// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Wheel speeds on their way to what the host asked for, and wheels that stall.
class WheelRamp {
 public:
  static constexpr int kTopSpeed_mmps = 2200;
  static constexpr int kTopTurn_degps = 500;

  explicit WheelRamp(double track_m) : track_m_{track_m} {}

  void set_acceleration(int mmps2);  ///< below 0: deceleration
  void set_max_speed(int mmps);
  void want_wheels(const arcos::WheelSpeeds& speeds);
  void want_speed(int mmps);       ///< straight on, keeping the turn rate
  void want_turn_rate(int degps);  ///< keeping the speed
  void want_heading(int degrees) { heading_rad_ = degrees * std::numbers::pi / 180.0; }
  void want_stop();
  /// At zero at once, whatever the deceleration.
  void halt();

  struct Speeds {
    double left_mps = 0.0;
    double right_mps = 0.0;
  };
  /// Speeds at `now`. @param yaw_rad  by the robot's odometry
  [[nodiscard]] Speeds at(Time now, double yaw_rad);
  /// To be told how fast the wheels really are; 0.5 s far too slow is a stall.
  void see(double left_mps, double right_mps, Time now);
  [[nodiscard]] bool left_stalls(Time now) const { return stalls(left_slow_, now); }
  [[nodiscard]] bool right_stalls(Time now) const { return stalls(right_slow_, now); }

 private:
  [[nodiscard]] double approach(double speed, double goal, double span_s) const;
  [[nodiscard]] static bool stalls(const std::optional<Time>& since, Time now) {
    return since && now - *since >= std::chrono::milliseconds{500};
  }
  double track_m_;
  double acceleration_ = 0.3;  // m/s2, as the robot is delivered
  double deceleration_ = 0.3;
  double most_mps_ = 1.5;
  double ahead_goal_ = 0.0;  // m/s
  double turn_goal_ = 0.0;   // rad/s
  std::optional<double> heading_rad_;
  Speeds speeds_;
  std::optional<Time> last_;
  std::optional<Time> left_slow_;
  std::optional<Time> right_slow_;
};

}  // namespace caravan::bridge
