// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace caravan::world {

/// A wheel command that the motors can execute, and how it was corrected.
struct Sanitised {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool refused = false;  ///< a speed was not finite: both wheels stop
  bool clamped = false;  ///< a speed was beyond the limit and is clamped to it
  bool operator==(const Sanitised&) const = default;
};

/// @param limit_mps  rim speed, > 0
[[nodiscard]] inline Sanitised sanitise(double left_mps, double right_mps, double limit_mps) {
  if (!std::isfinite(left_mps) || !std::isfinite(right_mps)) return {.refused = true};
  return {.left_mps = std::clamp(left_mps, -limit_mps, limit_mps),
          .right_mps = std::clamp(right_mps, -limit_mps, limit_mps),
          .refused = false,
          .clamped = std::abs(left_mps) > limit_mps || std::abs(right_mps) > limit_mps};
}

}  // namespace caravan::world
