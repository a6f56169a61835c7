// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/sensing/settings.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// Where on the outline of the body something is touched, frame B, and the direction in which it lies.
struct Touch {
  Point at_B{0.0, 0.0};
  Point towards_B{1.0, 0.0};
  double either_side_m = 0.0;  ///< it may be so far beside `at_B`, across `towards_B`
};

/// Notices by its wheels that the body runs into something: a wheel that turned as it was told is slowed to
/// less than a share of it while the command stays.
///
/// A robot whose motors accelerate slowly, or that is told to stop, loses nothing of what its wheels had
/// reached. GPS and compass are not needed, so their noise does no harm. Wheels that slip instead are the
/// StuckMonitor's, and so are sensor frames that are too far apart: what is late by some of them looks like a
/// loss of speed.
class TouchSensor {
 public:
  explicit TouchSensor(const TouchSensing& settings) : settings_{settings} {}

  /// To be called in every step.
  /// @param told  the rim speeds of the step before
  /// @return once for each touch
  [[nodiscard]] std::optional<Touch> update(Time now, const Sensors& sensors, const Wheels& told,
                                            const Body& body);

 private:
  struct Sample {
    Time at{0};
    std::array<double, 2> angle_rad{};  // left, right
    std::array<double, 2> told_mps{};
  };
  /// Rim speed of a wheel as its angle tells, so many steps before now.
  [[nodiscard]] double speed_mps(std::size_t wheel, std::size_t before, double wheel_radius_m) const;
  [[nodiscard]] bool is_gapless() const;
  [[nodiscard]] bool has_lost_speed(std::size_t wheel, double wheel_radius_m) const;
  TouchSensing settings_;
  std::array<Sample, 8> samples_{};  // the latest first
  std::size_t count_ = 0;
  Time last_touch_{-std::chrono::hours{1}};
};

}  // namespace caravan::agent
