// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// A heading in the counts of a SIP, 0 to 4095.
[[nodiscard]] std::int16_t heading_counts(double yaw_rad);

/// Dead reckoning of the emulated robot, from the rotation of its wheels. It is wrong where they slip.
class DeadReckoning {
 public:
  DeadReckoning(const arcos::Factors& factors, double track_m, double wheel_radius_m)
      : factors_{factors}, track_m_{track_m}, wheel_radius_m_{wheel_radius_m} {}

  void turn(double left_wheel_rad, double right_wheel_rad, Time now);
  void set_origin() { x_m_ = y_m_ = yaw_rad_ = 0.0; }

  /// Writes position, heading and wheel speeds in the units of a SIP.
  void write(arcos::Sip& sip) const;
  [[nodiscard]] double yaw_rad() const { return yaw_rad_; }
  /// Distance since the robot was switched on; backwards negative.
  [[nodiscard]] double travelled_m() const { return 0.5 * (left_m_ + right_m_); }
  [[nodiscard]] double left_m() const { return left_m_; }
  [[nodiscard]] double right_m() const { return right_m_; }
  [[nodiscard]] double left_mps() const { return left_mps_; }
  [[nodiscard]] double right_mps() const { return right_mps_; }

 private:
  struct Seen {
    double left_m, right_m;
    Time at;
  };
  arcos::Factors factors_;
  double track_m_;
  double wheel_radius_m_;
  std::optional<Seen> last_;
  double x_m_ = 0.0;
  double y_m_ = 0.0;
  double yaw_rad_ = 0.0;
  double left_m_ = 0.0;
  double right_m_ = 0.0;
  double left_mps_ = 0.0;
  double right_mps_ = 0.0;
};

}  // namespace caravan::bridge
