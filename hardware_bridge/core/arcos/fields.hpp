// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "hardware_bridge/core/arcos/packet.hpp"

namespace caravan::bridge::arcos {

/// Reads little-endian fields from the front of a packet's data, never beyond its end.
class FieldReader {
 public:
  explicit FieldReader(std::span<const std::uint8_t> data) : data_{data} {}

  /// False: the field is incomplete, and `field` is unchanged.
  template <typename Field>
  bool read(Field& field) {
    if (data_.size() < sizeof(Field)) return false;
    unsigned value = data_[0];
    if constexpr (sizeof(Field) == 2) value |= static_cast<unsigned>(data_[1]) << 8U;
    field = static_cast<Field>(value);
    data_ = data_.subspan(sizeof(Field));
    return true;
  }
  /// An optional field: after the first incomplete one, none follows.
  template <typename Field>
  bool read(std::optional<Field>& field) {
    Field value{};
    if (!read(value)) return false;
    field = value;
    return true;
  }
  /// Text up to a NUL.
  bool read(std::string& text) {
    const auto end = std::find(data_.begin(), data_.end(), 0);
    if (end == data_.end()) return false;
    text.assign(data_.begin(), end);
    data_ = data_.subspan(text.size() + 1);
    return true;
  }

 private:
  std::span<const std::uint8_t> data_;
};

/// Writes little-endian fields.
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
  void write(const std::string& text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

}  // namespace caravan::bridge::arcos
