// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/settings.hpp"

#include "hardware_bridge/core/arcos/fields.hpp"

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kType = 0x20;

/// Passes each field to `take`, in the order of the packet, until it returns false.
template <typename SettingsOrConst, typename Take>
bool each_of_all_robots(SettingsOrConst& it, const Take& take) {
  return take(it.type) && take(it.subtype) && take(it.serial_number) && take(it.four_motors) &&
         take(it.top_turn_degps) && take(it.top_speed_mmps) && take(it.top_turn_acceleration_degps2) &&
         take(it.top_acceleration_mmps2) && take(it.top_pulse_width) && take(it.name) &&
         take(it.sip_period_ms) && take(it.host_baud) && take(it.auxiliary_baud) && take(it.gripper) &&
         take(it.front_sonar) && take(it.rear_sonar) && take(it.low_battery_dv) && take(it.ticks_per_turn) &&
         take(it.watchdog_ms);
}

template <typename SettingsOrConst, typename Take>
bool each_of_newer_robots(SettingsOrConst& it, const Take& take) {
  return take(it.alternative_sip) && take(it.stall_pulse_width) && take(it.stall_ms) &&
         take(it.joystick_speed_mmps) && take(it.joystick_turn_degps) && take(it.max_turn_degps) &&
         take(it.max_speed_mmps) && take(it.turn_acceleration_degps2) && take(it.turn_deceleration_degps2) &&
         take(it.turn_gain_p) && take(it.turn_gain_v) && take(it.turn_gain_i) &&
         take(it.acceleration_mmps2) && take(it.deceleration_mmps2) && take(it.speed_gain_p) &&
         take(it.speed_gain_v) && take(it.speed_gain_i) && take(it.front_bumpers) && take(it.rear_bumpers) &&
         take(it.charger) && take(it.sonar_cycle_ms) && take(it.automatic_baud) && take(it.gyro) &&
         take(it.drift_factor) && take(it.auxiliary_2_baud) && take(it.auxiliary_3_baud) &&
         take(it.ticks_per_mm) && take(it.shutdown_dv) && take(it.firmware) && take(it.gyro_clockwise) &&
         take(it.gyro_counter_clockwise) && take(it.kinematics_delay_ms) && take(it.top_sideways_mmps) &&
         take(it.top_sideways_acceleration_mmps2) && take(it.max_sideways_mmps) &&
         take(it.sideways_acceleration_mmps2) && take(it.sideways_deceleration_mmps2) &&
         take(it.charge_threshold_dv);
}

/// Sets a field to 0, or to an empty text.
struct Clear {
  template <typename Field>
  bool operator()(Field& field) const {
    field = Field{};
    return true;
  }
};

}  // namespace

Bytes encode(const Settings& settings) {
  FieldWriter out;
  out.write(kType);
  const auto write = [&](const auto& field) {
    out.write(field);
    return true;
  };
  (void)(each_of_all_robots(settings, write) && each_of_newer_robots(settings, write));
  return out.take();
}

std::optional<Settings> decode_settings(std::span<const std::uint8_t> data) {
  FieldReader in{data};
  std::uint8_t type = 0;
  Settings settings;
  const auto read = [&](auto& field) { return in.read(field); };
  if (!in.read(type) || type != kType || !each_of_all_robots(settings, read)) return std::nullopt;
  (void)each_of_newer_robots(settings, Clear{});
  (void)each_of_newer_robots(settings, read);
  return settings;
}

}  // namespace caravan::bridge::arcos
