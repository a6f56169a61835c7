// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/tuning.hpp"

#include <algorithm>
#include <cstdlib>

namespace caravan::bridge {
namespace {

using arcos::Order;

constexpr double kMillimetre = 0.001;
constexpr double kDegree = std::numbers::pi / 180.0;

std::uint16_t up_to(int value, std::uint16_t top) {
  return static_cast<std::uint16_t>(std::min(std::abs(value), static_cast<int>(top)));
}

/// Ignores 0: with a maximum or an acceleration of 0 the robot could not move.
void set(std::uint16_t& field, int value, std::uint16_t top) {
  if (value != 0) field = up_to(value, top);
}

std::uint16_t* gain_of(arcos::Settings& settings, Order order) {
  switch (order) {
    case Order::kTurnGainP:
      return &settings.turn_gain_p;
    case Order::kTurnGainV:
      return &settings.turn_gain_v;
    case Order::kTurnGainI:
      return &settings.turn_gain_i;
    case Order::kSpeedGainP:
      return &settings.speed_gain_p;
    case Order::kSpeedGainV:
      return &settings.speed_gain_v;
    case Order::kSpeedGainI:
      return &settings.speed_gain_i;
    case Order::kTicksPerTurn:
      return &settings.ticks_per_turn;
    case Order::kTicksPerMm:
      return &settings.ticks_per_mm;
    default:
      return nullptr;
  }
}

}  // namespace

bool tune(arcos::Settings& settings, Order order, int value) {
  if (std::uint16_t* gain = gain_of(settings, order)) {
    *gain = up_to(value, 0xffff);
    return true;
  }
  switch (order) {
    case Order::kSetMaxSpeed:
      set(settings.max_speed_mmps, value, settings.top_speed_mmps);
      return true;
    case Order::kSetMaxTurnRate:
      set(settings.max_turn_degps, value, settings.top_turn_degps);
      return true;
    case Order::kSetAcceleration:
      set(value < 0 ? settings.deceleration_mmps2 : settings.acceleration_mmps2, value,
          settings.top_acceleration_mmps2);
      return true;
    case Order::kSetTurnAcceleration:
      set(value < 0 ? settings.turn_deceleration_degps2 : settings.turn_acceleration_degps2, value,
          settings.top_turn_acceleration_degps2);
      return true;
    case Order::kSonarCycle:
      settings.sonar_cycle_ms = static_cast<std::uint8_t>(std::clamp(value, 2, 120));
      return true;
    case Order::kDriftFactor:
      settings.drift_factor = static_cast<std::int16_t>(std::clamp(value, -32768, 32767));
      return true;
    default:
      return false;
  }
}

MotionLimits limits_of(const arcos::Settings& settings) {
  return {.speed_mps = kMillimetre * settings.max_speed_mmps,
          .turn_radps = kDegree * settings.max_turn_degps,
          .acceleration_mps2 = kMillimetre * settings.acceleration_mmps2,
          .deceleration_mps2 = kMillimetre * settings.deceleration_mmps2,
          .turn_acceleration_radps2 = kDegree * settings.turn_acceleration_degps2,
          .turn_deceleration_radps2 = kDegree * settings.turn_deceleration_degps2,
          .wheel_mps = kMillimetre * settings.top_speed_mmps};
}

}  // namespace caravan::bridge
