// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "hardware_bridge/core/arcos/sip.hpp"

namespace caravan::bridge::arcos {

/// Scale of the odometry of a robot subtype.
struct Factors {
  double position_m = 0.001;  ///< metres per count of x and y in a SIP
};
/// None for a subtype without known factors.
[[nodiscard]] std::optional<Factors> factors_of(std::string_view subtype);

inline constexpr int kHeadingCounts = 4096;  ///< counts per turn

/// Motion of the base between two SIPs, by the robot's own dead reckoning.
struct Moved {
  double ahead_m = 0.0;  ///< along the mean heading; backwards negative
  double turned_rad = 0.0;
};

/// Evaluates the odometry of successive SIPs across the wraps of its counters.
class Odometry {
 public:
  explicit Odometry(const Factors& factors) : factors_{factors} {}

  /// Motion since the previous SIP; none for the first. @pre less than 2^14 counts and half a turn between
  /// two SIPs
  [[nodiscard]] Moved follow(const Sip& sip);
  /// Treats the next SIP as the first: the counters may have been reset in between.
  void restart() { last_.reset(); }

 private:
  struct Counts {
    int x, y, heading;
  };
  Factors factors_;
  std::optional<Counts> last_;
};

}  // namespace caravan::bridge::arcos
