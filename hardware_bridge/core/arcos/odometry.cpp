// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/odometry.hpp"

#include <cmath>
#include <numbers>

namespace caravan::bridge::arcos {
namespace {

constexpr int kPositionCounts = 1 << 15;
constexpr double kRadiansPerCount = 2.0 * std::numbers::pi / kHeadingCounts;

/// Difference of two wrapping counters, the one nearest to zero.
int difference(int now, int before, int wraps_at) {
  int change = (now - before) % wraps_at;
  if (change < 0) change += wraps_at;
  return change >= wraps_at / 2 ? change - wraps_at : change;
}

}  // namespace

std::optional<Factors> factors_of(std::string_view subtype) {
  if (subtype == "p3dx") return Factors{.position_m = 0.485e-3};
  if (subtype == "p3dx-sh") return Factors{.position_m = 1.0e-3};
  return std::nullopt;
}

Moved Odometry::follow(const Sip& sip) {
  const Counts now{sip.x & (kPositionCounts - 1), sip.y & (kPositionCounts - 1), sip.heading};
  if (!last_) {
    last_ = now;
    return {};
  }
  const double dx = factors_.position_m * difference(now.x, last_->x, kPositionCounts);
  const double dy = factors_.position_m * difference(now.y, last_->y, kPositionCounts);
  const double turned = kRadiansPerCount * difference(now.heading, last_->heading, kHeadingCounts);
  const double half_way = kRadiansPerCount * last_->heading + 0.5 * turned;
  last_ = now;
  return {dx * std::cos(half_way) + dy * std::sin(half_way), turned};
}

}  // namespace caravan::bridge::arcos
