// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/forward_view.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

}  // namespace

ForwardView::View ForwardView::update(const Perception& seen, double free_ahead_m, const MeetingRule& rule) {
  const double free = believed(seen, free_ahead_m, rule);
  return {free, closing(seen.now, free, rule.closing_period)};
}

double ForwardView::believed(const Perception& seen, double free_ahead_m, const MeetingRule& rule) {
  const double came = (seen.p_WB - echo_seen_from_).dot(direction(echo_seen_at_yaw_rad_));
  const double expected = std::max(0.0, last_echo_.free_ahead_m - came);
  const bool recent = seen.now - last_echo_.at <= rule.lost_echo && seen.robot_near &&
                      std::abs(wrapped(seen.yaw_WB_rad - echo_seen_at_yaw_rad_)) < rule.lost_echo_turn_rad;
  if (recent && free_ahead_m > expected + rule.lost_echo_jump_m) return expected;
  if (free_ahead_m < rule.lost_echo_range_m) {
    last_echo_ = {seen.now, free_ahead_m};
    echo_seen_from_ = seen.p_WB;
    echo_seen_at_yaw_rad_ = seen.yaw_WB_rad;
  }
  return free_ahead_m;
}

double ForwardView::closing(Time now, double free_ahead_m, Time period) {
  if (now - samples_[1].at >= period) {
    samples_[0] = samples_[1];
    samples_[1] = {now, free_ahead_m};
  }
  const Time span = now - samples_[0].at;
  if (!std::isfinite(samples_[0].free_ahead_m) || span <= 0ms || span > 3 * period) {
    return std::numeric_limits<double>::infinity();
  }
  return (samples_[0].free_ahead_m - free_ahead_m) / std::chrono::duration<double>(span).count();
}

}  // namespace caravan::agent
