// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace caravan::radio {

struct Station;

/// An upright rectangle in frame W, metres, edges included.
struct Area {
  double low_x_m = 0.0;
  double low_y_m = 0.0;
  double high_x_m = 0.0;
  double high_y_m = 0.0;
};

/// A rule for the loss on some links, in both directions.
struct LinkRule {
  std::vector<std::uint32_t> robots;  ///< one end; empty: any robot
  std::vector<std::uint32_t> others;  ///< the other end; empty: any robot
  std::optional<Area> area;           ///< only links with at least one end inside
  std::optional<double> loss;         ///< probability for each frame; none: the scenario's value
};

/// The loss on the link between two stations, from the newest rule (the last) that matches it. None: no rule
/// matches, or the newest one has no loss.
[[nodiscard]] std::optional<double> loss_on(std::span<const LinkRule> rules, const Station& one,
                                            const Station& other);

}  // namespace caravan::radio
