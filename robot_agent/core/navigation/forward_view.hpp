// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// The free distance ahead, filtered over time.
///
/// A robot ahead that turns shows its corner, which returns no echo. While another robot is received, an echo
/// that vanishes suddenly is therefore kept for MeetingRule::lost_echo. The rate at which the free distance
/// shrinks distinguishes a robot that approaches or stands from one that drives ahead in the same direction.
class ForwardView {
 public:
  struct View {
    double free_ahead_m = std::numeric_limits<double>::infinity();
    double closing_mps = std::numeric_limits<double>::infinity();  ///< +inf: unknown, as for a new echo
  };
  [[nodiscard]] View update(const Perception& seen, double free_ahead_m, const MeetingRule& rule);

 private:
  struct Sample {
    Time at{0};
    double free_ahead_m = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] double believed(const Perception& seen, double free_ahead_m, const MeetingRule& rule);
  [[nodiscard]] double closing(Time now, double free_ahead_m, Time period);
  std::array<Sample, 2> samples_;  // [0] older
  Sample last_echo_;
  Point echo_seen_from_{0.0, 0.0};
  double echo_seen_at_yaw_rad_ = 0.0;
};

}  // namespace caravan::agent
