// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/sip.hpp"

#include <algorithm>

#include "hardware_bridge/core/arcos/fields.hpp"

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kStoppedType = 0x32;
constexpr std::uint8_t kMovingType = 0x33;
constexpr std::uint8_t kThirdSync = 2;
constexpr std::size_t kMostSonars = 32;

bool read_head(FieldReader& in, Sip& sip) {
  return in.read(sip.x) && in.read(sip.y) && in.read(sip.heading) && in.read(sip.left_mmps) &&
         in.read(sip.right_mmps) && in.read(sip.battery_dv) && in.read(sip.stall_and_bumpers) &&
         in.read(sip.control) && in.read(sip.flags) && in.read(sip.compass);
}

bool read_sonars(FieldReader& in, Sip& sip) {
  std::uint8_t count = 0;
  if (!in.read(count)) return false;
  for (; count > 0; --count) {
    Sip::Sonar sonar;
    if (!in.read(sonar.index) || !in.read(sonar.range_mm)) return false;
    sip.sonars.push_back(sonar);
  }
  return true;
}

}  // namespace

std::optional<Sip> decode_sip(std::span<const std::uint8_t> data) {
  FieldReader in{data};
  std::uint8_t type = 0;
  Sip sip;
  if (!in.read(type) || (type != kStoppedType && type != kMovingType)) return std::nullopt;
  sip.moving = type == kMovingType;
  if (!read_head(in, sip) || !read_sonars(in, sip)) return std::nullopt;
  (void)(in.read(sip.gripper) && in.read(sip.analog_port) && in.read(sip.analog) && in.read(sip.digital_in) &&
         in.read(sip.digital_out) && in.read(sip.battery_fine_dv) && in.read(sip.charge) &&
         in.read(sip.turn_rate) && in.read(sip.fault));
  return sip;
}

Bytes encode(const Sip& sip) {
  FieldWriter out;
  out.write(sip.moving ? kMovingType : kStoppedType);
  out.write(sip.x);
  out.write(sip.y);
  out.write(sip.heading);
  out.write(sip.left_mmps);
  out.write(sip.right_mmps);
  out.write(sip.battery_dv);
  out.write(sip.stall_and_bumpers);
  out.write(sip.control);
  out.write(sip.flags);
  out.write(sip.compass);
  const std::size_t sonars = std::min(sip.sonars.size(), kMostSonars);
  out.write(static_cast<std::uint8_t>(sonars));
  for (std::size_t i = 0; i < sonars; ++i) {
    out.write(sip.sonars[i].index);
    out.write(sip.sonars[i].range_mm);
  }
  (void)(out.write(sip.gripper) && out.write(sip.analog_port) && out.write(sip.analog) &&
         out.write(sip.digital_in) && out.write(sip.digital_out) && out.write(sip.battery_fine_dv) &&
         out.write(sip.charge) && out.write(sip.turn_rate) && out.write(sip.fault));
  return out.take();
}

Bytes encode(const Names& names) {
  FieldWriter out;
  out.write(kThirdSync);
  out.write(names.name);
  out.write(names.type);
  out.write(names.subtype);
  return out.take();
}

std::optional<Names> decode_names(std::span<const std::uint8_t> data) {
  FieldReader in{data};
  std::uint8_t number = 0;
  Names names;
  if (!in.read(number) || number != kThirdSync) return std::nullopt;
  if (!in.read(names.name) || !in.read(names.type) || !in.read(names.subtype)) return std::nullopt;
  return names;
}

}  // namespace caravan::bridge::arcos
