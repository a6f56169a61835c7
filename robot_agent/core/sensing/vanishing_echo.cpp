// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/vanishing_echo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace caravan::agent {
namespace {

constexpr std::array<std::size_t, 2> kStraightAhead = {3, 4};  // indices in the robot model

/// Ranges of the two forward sonars, ahead of the base.
std::array<double, 2> straight_ahead_m(const Surroundings& around) {
  std::array<double, 2> ahead;
  ahead.fill(std::numeric_limits<double>::infinity());
  for (const Echo& echo : around.echoes()) {
    for (std::size_t i = 0; i < ahead.size(); ++i) {
      if (echo.sonar == kStraightAhead[i]) ahead[i] = echo.p_B.x();
    }
  }
  return ahead;
}

}  // namespace

std::optional<double> VanishingEcho::update(const Perception& seen) {
  const auto [left, right] = straight_ahead_m(seen.around);
  const bool robot = straight_ahead_m(seen.still) != straight_ahead_m(seen.around) ||
                     (seen.robot_near && seen.robots.empty());
  const bool turned =
      first_ && std::abs(wrapped(seen.yaw_WB_rad - first_->yaw_WB_rad)) > settings_.straight_rad;
  if (robot || turned) first_.reset();
  if (robot) return std::nullopt;
  if (std::max(left, right) < settings_.seen_m && std::abs(left - right) < settings_.one_thing_m) {
    last_ = {seen.now, seen.p_WB, seen.yaw_WB_rad, std::min(left, right)};
    if (!first_) first_ = last_;
    return std::nullopt;
  }
  if (!first_) return std::nullopt;
  const Point ahead = direction(seen.yaw_WB_rad);
  const double expected = last_.ahead_m - ahead.dot(seen.p_WB - last_.p_WB);
  const bool late = seen.now - last_.at > settings_.together;
  if (!late && std::min(left, right) < expected + settings_.farther_m)
    return std::nullopt;  // one of the two still sees it
  const double approached = ahead.dot(seen.p_WB - first_->p_WB);
  first_.reset();
  if (late || approached < settings_.approach_m || last_.ahead_m < settings_.nearest_m ||
      last_.ahead_m > settings_.farthest_m) {
    return std::nullopt;
  }
  return expected;
}

}  // namespace caravan::agent
