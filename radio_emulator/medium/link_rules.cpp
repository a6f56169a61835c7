// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/link_rules.hpp"

#include <algorithm>

#include "radio_emulator/medium/medium.hpp"

namespace caravan::radio {
namespace {

bool names(const std::vector<std::uint32_t>& robots, const Station& station) {
  return robots.empty() || std::find(robots.begin(), robots.end(), station.robot) != robots.end();
}

bool is_in(const Area& area, const Station& station) {
  return station.x_m >= area.low_x_m && station.x_m <= area.high_x_m && station.y_m >= area.low_y_m &&
         station.y_m <= area.high_y_m;
}

bool matches(const LinkRule& rule, const Station& one, const Station& other) {
  const bool has_ends = (names(rule.robots, one) && names(rule.others, other)) ||
                        (names(rule.robots, other) && names(rule.others, one));
  return has_ends && (!rule.area || is_in(*rule.area, one) || is_in(*rule.area, other));
}

}  // namespace

std::optional<double> loss_on(std::span<const LinkRule> rules, const Station& one, const Station& other) {
  const auto newest = std::find_if(rules.rbegin(), rules.rend(),
                                   [&](const LinkRule& rule) { return matches(rule, one, other); });
  return newest == rules.rend() ? std::nullopt : newest->loss;
}

}  // namespace caravan::radio
