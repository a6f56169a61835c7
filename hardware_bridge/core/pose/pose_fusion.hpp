// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

struct FusionConfig {
  bool has_gps = true;
  bool has_compass = true;
  Pose start;  ///< where the robot stands at first; the position matters without GPS, the yaw without compass
  Point antenna_B;             ///< where the GPS antenna is on the robot: x forward, y left
  double gps_trust = 0.3;      ///< share of a fix's difference that is taken at once, in (0, 1]
  double compass_trust = 0.1;  ///< the same of a compass reading
  Time gps_timeout = std::chrono::milliseconds{400};  ///< without a fix for so long the position is not known
};

/// Where the robot is, from its odometry, GPS and compass.
///
/// Odometry carries the pose from one SIP to the next. Each fix draws the position towards itself by
/// `gps_trust`, each compass reading the yaw by `compass_trust`: what odometry gets wrong slowly is put
/// right, what the others get wrong quickly is averaged. Without a compass the yaw begins at `start` and is
/// put right by the direction between fixes after every half metre of way.
class PoseFusion {
 public:
  explicit PoseFusion(const FusionConfig& config);

  void move(const arcos::Moved& moved);
  /// @param yaw_rad  in W
  void read_compass(double yaw_rad);
  /// @param antenna_W  where the GPS says that its antenna is; believed (see FixGate)
  /// @param anew       the position begins anew there
  void fix(const Point& antenna_W, Time now, bool anew = false);
  /// Where the antenna is, as far as is known without the next fix.
  [[nodiscard]] Point antenna_W() const;
  /// The receiver says that it has no fix.
  void lose_fix() { last_fix_.reset(); }

  /// None while the position or the heading is not known.
  [[nodiscard]] std::optional<Pose> pose(Time now) const;
  /// Is there a source of position, now?
  [[nodiscard]] bool has_position(Time now) const;
  /// Until when, if no fix comes any more.
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
    Point fix_W;       // base, by GPS
    Point reckoned_W;  // base, by odometry alone since then
  };
  std::optional<Anchor> anchor_;
  Point reckoned_W_;  // moved by odometry only
};

}  // namespace caravan::bridge
