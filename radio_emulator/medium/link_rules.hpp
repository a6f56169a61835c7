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

/// What somebody has told the radio about some links, in both directions.
struct LinkRule {
  std::vector<std::uint32_t> robots;  ///< one end; empty: any robot
  std::vector<std::uint32_t> others;  ///< the other end; empty: any robot
  std::optional<Area> area;           ///< only links with an end in it
  std::optional<double> loss;         ///< probability for each frame; none: as the scenario has it
};

/// The loss on the link between two stations by the newest rule (the last) that matches it. None: no rule
/// matches or the newest has none.
[[nodiscard]] std::optional<double> loss_on(std::span<const LinkRule> rules, const Station& one,
                                            const Station& other);

}  // namespace caravan::radio
