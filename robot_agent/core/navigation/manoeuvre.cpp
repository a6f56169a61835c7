// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/manoeuvre.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot_agent/core/navigation/steering.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {
std::optional<Wheels> Performance::step(const Perception& seen, const Manoeuvres& settings,
                                        const Driving& driving, const Body& body) {
  while (current_ < legs_.size()) {
    if (!begun_) {
      begun_ = true;
      leg_began_at_ = seen.p_WB;
      leg_began_ = seen.now;
      leg_gives_up_ = seen.now + settings.leg_timeout;
    }
    std::optional<Wheels> wheels;
    if (seen.now < leg_gives_up_) {
      wheels = std::visit(
          pure::Overload{[&](const TurnTo& leg) { return perform(leg, seen, settings, driving, body); },
                         [&](const Go& leg) { return perform(leg, seen, settings, driving, body); },
                         [&](const Veer& leg) { return perform(leg, seen, settings, driving, body); },
                         [&](const Pause& leg) { return perform(leg, seen.now); }},
          legs_[current_]);
    }
    if (wheels) return wheels;
    skip();
  }
  return std::nullopt;
}

void Performance::skip() {
  ++current_;
  begun_ = false;
}

std::optional<Wheels> Performance::perform(const TurnTo& leg, const Perception& seen,
                                           const Manoeuvres& settings, const Driving& driving,
                                           const Body& body) const {
  const double error = wrapped(leg.yaw_WB_rad - seen.yaw_WB_rad);
  if (std::abs(error) < settings.heading_tolerance_rad) return std::nullopt;
  return turn_to(error, driving, body);
}

std::optional<Wheels> Performance::perform(const Go& leg, const Perception& seen, const Manoeuvres& settings,
                                           const Driving& driving, const Body& body) const {
  if (seen.distance_to(leg_began_at_) >= std::abs(leg.distance_m)) return std::nullopt;
  if (leg.distance_m < 0.0) {
    if (free_behind_m(seen.around, body) < settings.behind_m) return std::nullopt;
    return wheels_for(-settings.reverse_mps, 0.0, body);
  }
  const double ahead = free_alongside_m(seen.around, body);
  if (ahead < settings.ahead_m) return std::nullopt;
  return wheels_for(std::max(driving.slow_mps,
                             std::min(settings.speed_share * driving.cruise_mps, speed_for(ahead, driving))),
                    0.0, body);
}

std::optional<Wheels> Performance::perform(const Veer& leg, const Perception& seen,
                                           const Manoeuvres& settings, const Driving& driving,
                                           const Body& body) const {
  if (seen.distance_to(leg_began_at_) >= leg.distance_m) return std::nullopt;
  if (free_alongside_m(seen.still, body) < settings.ahead_m) return std::nullopt;
  return steer_to(wrapped(leg.yaw_WB_rad - seen.yaw_WB_rad), settings.speed_share * driving.cruise_mps,
                  driving, body);
}

std::optional<Wheels> Performance::perform(const Pause& leg, Time now) const {
  if (now - leg_began_ >= leg.duration) return std::nullopt;
  return Wheels{};
}

}  // namespace caravan::agent
