// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Detects a robot that makes no progress. Places that it remembers within forget_radius_m() may then be
/// wrong.
class Patience {
 public:
  explicit Patience(const PatienceSettings& settings) : settings_{settings} {}
  /// Call in every step. @return true once per PatienceSettings::timeout without progress
  [[nodiscard]] bool is_lost(const Perception& seen) {
    if (seen.distance_to(got_to_) > settings_.somewhere_m) {
      got_to_ = seen.p_WB;
      got_there_ = seen.now;
    }
    if (seen.now - got_there_ <= settings_.timeout) return false;
    got_there_ = seen.now;
    return true;
  }
  [[nodiscard]] double forget_radius_m() const { return settings_.forget_radius_m; }

 private:
  PatienceSettings settings_;
  Point got_to_{0.0, 0.0};
  Time got_there_{0};
};

}  // namespace caravan::agent
