// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

struct FusionConfig {
  bool has_gps = true;
  bool has_compass = true;
  Pose start;                  ///< initial pose; the position is used without GPS, the yaw without compass
  Point antenna_B;             ///< position of the GPS antenna: x forward, y left
  double gps_trust = 0.3;      ///< share of a fix's difference that is corrected at once, in (0, 1]
  double compass_trust = 0.1;  ///< the same of a compass reading
  Time gps_timeout = std::chrono::milliseconds{400};  ///< longest time without a fix; then position unknown
};

/// Estimates the robot's pose from odometry, GPS and compass.
///
/// Odometry moves the pose from one SIP to the next. Each fix corrects the position by the share `gps_trust`,
/// each compass reading the yaw by `compass_trust`: slow drift of the odometry is corrected, and noise of the
/// others is averaged. Without a compass the yaw starts at `start` and is corrected after every half metre,
/// by the direction between fixes.
class PoseFusion {
 public:
  explicit PoseFusion(const FusionConfig& config);

  void move(const arcos::Moved& moved);
  /// @param yaw_rad  in W
  void read_compass(double yaw_rad);
  /// @param antenna_W  position of the antenna by GPS; accepted by FixGate
  /// @param anew       the position starts anew there
  void fix(const Point& antenna_W, Time now, bool anew = false);
  /// Predicted position of the antenna, before the next fix.
  [[nodiscard]] Point antenna_W() const;
  /// The receiver reports that it has no fix.
  void lose_fix() { last_fix_.reset(); }

  /// None while the position or the yaw is unknown.
  [[nodiscard]] std::optional<Pose> pose(Time now) const;
  /// Whether there is a source of position now.
  [[nodiscard]] bool has_position(Time now) const;
  /// When the position becomes unknown if no further fix arrives.
  [[nodiscard]] Time loses_position_at(Time now) const;

 private:
  void learn_yaw_from_way(const Point& base_W);
  [[nodiscard]] Point to_W(const Point& p_B) const;

  FusionConfig config_;
  Pose pose_;
  bool yaw_known_;
  std::optional<Time> last_fix_;
  bool placed_;  // the position has been set once
  struct Anchor {
    Point fix_W;       // base by GPS, at the anchor
    Point reckoned_W;  // base by odometry alone, at the anchor
  };
  std::optional<Anchor> anchor_;
  Point reckoned_W_;  // base by odometry alone
};

}  // namespace caravan::bridge
