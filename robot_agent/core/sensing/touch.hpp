// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/settings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// A contact: the point on the outline of the body, frame B, and the direction of the obstacle from there.
struct Touch {
  Point at_B{0.0, 0.0};
  Point towards_B{1.0, 0.0};
  double either_side_m = 0.0;  ///< uncertainty of `at_B` to either side, across `towards_B`
};

/// Detects by the wheels that the body runs into something: a wheel that had reached its command slows to
/// less than a share of it, although the command stays.
///
/// Slow acceleration and stop commands do not trigger it. It needs neither GPS nor compass, so their noise
/// does not matter. It does not cover wheels that slip; StuckMonitor does. Sensor frames too far apart are
/// not judged, because a delay looks like a loss of speed.
class TouchSensor {
 public:
  explicit TouchSensor(const TouchSensing& settings) : settings_{settings} {}

  /// Call in every step.
  /// @param told  rim speeds commanded in the previous step
  /// @return a touch, once
  [[nodiscard]] std::optional<Touch> update(Time now, const Sensors& sensors, const Wheels& told,
                                            const Body& body);

 private:
  struct Sample {
    Time at{0};
    std::array<double, 2> angle_rad{};  // left, right
    std::array<double, 2> told_mps{};
  };
  /// Rim speed of a wheel from its angle, some steps ago.
  [[nodiscard]] double speed_mps(std::size_t wheel, std::size_t before, double wheel_radius_m) const;
  [[nodiscard]] bool is_gapless() const;
  [[nodiscard]] bool has_lost_speed(std::size_t wheel, double wheel_radius_m) const;
  TouchSensing settings_;
  std::array<Sample, 8> samples_{};  // latest first
  std::size_t count_ = 0;
  Time last_touch_{-std::chrono::hours{1}};
};

}  // namespace caravan::agent
