// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "hardware_bridge/core/arcos/sip.hpp"

namespace caravan::bridge::arcos {

/// What a count of a robot's subtype means.
struct Factors {
  double position_m = 0.001;  ///< of x and y in a SIP
};
/// Empty for a subtype that this project has no numbers for.
[[nodiscard]] std::optional<Factors> factors_of(std::string_view subtype);

inline constexpr int kHeadingCounts = 4096;  ///< to the turn

/// How the base moved between two SIPs, by the robot's own dead reckoning.
struct Moved {
  double ahead_m = 0.0;  ///< along its heading half-way, backward negative
  double turned_rad = 0.0;
};

/// Follows the odometry of successive SIPs across the wraps of its counters.
class Odometry {
 public:
  explicit Odometry(const Factors& factors) : factors_{factors} {}

  /// Since the SIP before; nothing for the first. Right as long as less than 2^14 counts of way and half a
  /// turn lie between two SIPs.
  [[nodiscard]] Moved follow(const Sip& sip);
  /// The next SIP is a first one: the counters may have been set to zero meanwhile.
  void restart() { last_.reset(); }

 private:
  struct Counts {
    int x, y, heading;
  };
  Factors factors_;
  std::optional<Counts> last_;
};

}  // namespace caravan::bridge::arcos
