// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/settings.hpp"

#include "hardware_bridge/core/arcos/fields.hpp"

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kType = 0x20;

/// Gives each field to `take`, in the order of the packet, until it says false.
template <typename SettingsOrConst, typename Take>
bool all_of(SettingsOrConst& it, const Take& take) {
  return take(it.type) && take(it.subtype) && take(it.serial_number) && take(it.four_motors) &&
         take(it.top_turn_degps) && take(it.top_speed_mmps) && take(it.top_turn_acceleration_degps2) &&
         take(it.top_acceleration_mmps2) && take(it.top_pulse_width) && take(it.name) &&
         take(it.sip_period_ms) && take(it.host_baud) && take(it.auxiliary_baud) && take(it.gripper) &&
         take(it.front_sonar) && take(it.rear_sonar) && take(it.low_battery_dv) && take(it.ticks_per_turn) &&
         take(it.watchdog_ms);
}

}  // namespace

Bytes encode(const Settings& settings) {
  FieldWriter out;
  out.write(kType);
  (void)all_of(settings, [&](const auto& field) {
    out.write(field);
    return true;
  });
  return out.take();
}

std::optional<Settings> decode_settings(std::span<const std::uint8_t> data) {
  FieldReader in{data};
  std::uint8_t type = 0;
  Settings settings;
  if (!in.read(type) || type != kType) return std::nullopt;
  if (!all_of(settings, [&](auto& field) { return in.read(field); })) return std::nullopt;
  return settings;
}

}  // namespace caravan::bridge::arcos
