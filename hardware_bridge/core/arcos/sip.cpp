// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/sip.hpp"

#include <algorithm>

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kStoppedType = 0x32;
constexpr std::uint8_t kMovingType = 0x33;
constexpr std::uint8_t kThirdSync = 2;
constexpr std::size_t kMostSonars = 32;

/// Takes little-endian fields from the front of the data; asks nothing beyond its end.
class FieldReader {
 public:
  explicit FieldReader(std::span<const std::uint8_t> data) : data_{data} {}

  template <typename Field>
  bool read(Field& field) {
    if (data_.size() < sizeof(Field)) return false;
    unsigned value = data_[0];
    if constexpr (sizeof(Field) == 2) value |= static_cast<unsigned>(data_[1]) << 8U;
    field = static_cast<Field>(value);
    data_ = data_.subspan(sizeof(Field));
    return true;
  }
  /// The optional tail: once a field is not whole, none follows.
  template <typename Field>
  bool read(std::optional<Field>& field) {
    Field value{};
    if (!read(value)) return false;
    field = value;
    return true;
  }

 private:
  std::span<const std::uint8_t> data_;
};

class FieldWriter {
 public:
  template <typename Field>
  void write(Field field) {
    const auto value = static_cast<unsigned>(field);
    bytes_.push_back(static_cast<std::uint8_t>(value & 0xffU));
    if constexpr (sizeof(Field) == 2) bytes_.push_back(static_cast<std::uint8_t>((value >> 8U) & 0xffU));
  }
  template <typename Field>
  bool write(const std::optional<Field>& field) {
    if (field) write(*field);
    return field.has_value();
  }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

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
  Bytes data{kThirdSync};
  for (const std::string* name : {&names.name, &names.type, &names.subtype}) {
    data.insert(data.end(), name->begin(), name->end());
    data.push_back(0);
  }
  return data;
}

std::optional<Names> decode_names(std::span<const std::uint8_t> data) {
  if (data.empty() || data[0] != kThirdSync) return std::nullopt;
  Names names;
  std::size_t at = 1;
  for (std::string* name : {&names.name, &names.type, &names.subtype}) {
    const auto rest = data.subspan(at);
    const auto end = std::find(rest.begin(), rest.end(), 0);
    if (end == rest.end()) return std::nullopt;
    name->assign(rest.begin(), end);
    at += name->size() + 1;
  }
  return names;
}

}  // namespace caravan::bridge::arcos
