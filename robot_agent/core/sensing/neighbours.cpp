// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot_agent/core/angle.hpp"

namespace caravan::agent {
namespace {

constexpr double kFarthest_m = 1.0e6;  // from the origin; a frame has 32-bit millimetres

std::int16_t thousandths(double value) {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(1000.0 * value, -kMost, kMost)));
}

Neighbour moved_on(Neighbour neighbour, Time span) {
  const double dt = std::chrono::duration<double>(span).count();
  const double turned = dt * neighbour.turn_radps;
  neighbour.p_WB += dt * neighbour.speed_mps * direction(neighbour.yaw_WB_rad + 0.5 * turned);
  neighbour.yaw_WB_rad = wrapped(neighbour.yaw_WB_rad + turned);
  return neighbour;
}

}  // namespace

Neighbour carried_on(RobotId robot, const Whereabouts& told, Time after) {
  return moved_on({robot,
                   {0.001 * told.at.x_mm, 0.001 * told.at.y_mm},
                   0.001 * told.yaw_mrad,
                   0.001 * told.speed_mmps,
                   0.001 * told.turn_mradps},
                  after);
}

Neighbours::Neighbours(const NeighbourMemory& memory, Time wait_period)
    : remembers_{std::max(memory.duration, wait_period + wait_period / 5)},
      moves_on_{std::max(memory.extrapolation, remembers_ - memory.extrapolation)} {}

void Neighbours::hear(const Wait& wait, Time sent) {
  if (!wait.whereabouts) return;
  const Told told{carried_on(wait.from, *wait.whereabouts, Time{0}), sent};
  const auto found =
      std::ranges::lower_bound(told_, wait.from, {}, [](const Told& t) { return t.neighbour.id; });
  if (found != told_.end() && found->neighbour.id == wait.from) {
    *found = told;
  } else {
    told_.insert(found, told);
  }
}

std::vector<Neighbour> Neighbours::now(Time now) {
  std::erase_if(told_, [&](const Told& told) { return now - told.at > remembers_; });
  std::vector<Neighbour> result;
  result.reserve(told_.size());
  for (const Told& told : told_) {
    result.push_back(moved_on(told.neighbour, std::min(now - told.at, moves_on_)));
  }
  return result;
}

std::optional<Whereabouts> whereabouts_of(const Sensors& sensors, double speed_mps, double turn_radps) {
  const Point& p = sensors.p_WB;
  if (!(std::abs(p.x()) < kFarthest_m && std::abs(p.y()) < kFarthest_m)) return std::nullopt;
  if (!std::isfinite(sensors.yaw_WB_rad)) return std::nullopt;
  return Whereabouts{{static_cast<std::int32_t>(std::lround(1000.0 * p.x())),
                      static_cast<std::int32_t>(std::lround(1000.0 * p.y()))},
                     thousandths(wrapped(sensors.yaw_WB_rad)),
                     thousandths(speed_mps),
                     thousandths(turn_radps)};
}

}  // namespace caravan::agent
