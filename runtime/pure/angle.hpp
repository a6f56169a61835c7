// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace caravan::pure {

/// The same angle in (-pi, pi].
[[nodiscard]] inline double wrapped(double angle_rad) {
  const double turned = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return turned <= -std::numbers::pi ? std::numbers::pi : turned;
}

}  // namespace caravan::pure
