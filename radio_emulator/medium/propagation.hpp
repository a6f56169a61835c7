// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "runtime/pure/propagation_config.hpp"

namespace caravan::radio {

using pure::PropagationConfig;

/// Properties of the link between a sender and a receiver.
struct Link {
  double loss_probability = 0.0;
  double signal_strength_dbm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not reported
};

/// The greatest distance at which anything arrives, metres: robots further away need not be considered.
[[nodiscard]] constexpr double greatest_range_m(const PropagationConfig& config) { return config.range_m; }

/// The link over a distance, given by its square: the range rule then needs no root, and rounds the same
/// everywhere.
/// @return none: nothing arrives
[[nodiscard]] constexpr std::optional<Link> propagate(const PropagationConfig& config,
                                                      double distance_squared_m2) {
  if (distance_squared_m2 > config.range_m * config.range_m) return std::nullopt;
  return Link{.loss_probability = config.loss_probability};
}

}  // namespace caravan::radio
