// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/command.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kNotNegative = 0x3b;
constexpr std::uint8_t kNegative = 0x1b;
constexpr std::uint8_t kText = 0x2b;
constexpr int kMostMagnitude = 0xffff;

constexpr double kSpeedUnit_mmps = 20.0;
constexpr int kMostUnits = 126;

int units_of(double speed_mps) {
  const double units = std::clamp(1000.0 * speed_mps / kSpeedUnit_mmps, -1.0 * kMostUnits, 1.0 * kMostUnits);
  return static_cast<int>(std::lround(units));
}

int signed_byte(int byte) { return byte >= 128 ? byte - 256 : byte; }

}  // namespace

Bytes encode(const Command& command) {
  Bytes data{command.number};
  if (const int* number = std::get_if<int>(&command.argument)) {
    const int magnitude = std::min(std::abs(*number), kMostMagnitude);
    data.push_back(*number < 0 ? kNegative : kNotNegative);
    data.push_back(static_cast<std::uint8_t>(magnitude & 0xff));
    data.push_back(static_cast<std::uint8_t>(magnitude >> 8));
  } else if (const std::string* text = std::get_if<std::string>(&command.argument)) {
    data.push_back(kText);
    const std::size_t length = std::min(text->size(), kMostData - 2);
    data.insert(data.end(), text->begin(), text->begin() + static_cast<std::ptrdiff_t>(length));
  }
  return to_packet(data);
}

Bytes encode(Order order) { return encode(Command{static_cast<std::uint8_t>(order), {}}); }

Bytes encode(Order order, int argument) {
  return encode(Command{static_cast<std::uint8_t>(order), argument});
}

int number_of(const Command& command) {
  const int* number = std::get_if<int>(&command.argument);
  return number == nullptr ? 0 : *number;
}

std::optional<Command> decode_command(std::span<const std::uint8_t> data) {
  if (data.empty()) return std::nullopt;
  Command command{data[0], {}};
  if (data.size() == 1) return command;
  const bool is_number = data[1] == kNotNegative || data[1] == kNegative;
  if (is_number && data.size() == 4) {
    const int magnitude = data[2] | (data[3] << 8);
    command.argument = data[1] == kNegative ? -magnitude : magnitude;
    return command;
  }
  if (data[1] == kText) {
    command.argument = std::string{data.begin() + 2, data.end()};
    return command;
  }
  return std::nullopt;
}

int wheel_speeds_argument(double left_mps, double right_mps) {
  return ((units_of(left_mps) & 0xff) << 8) | (units_of(right_mps) & 0xff);
}

WheelSpeeds wheel_speeds_of(int argument) {
  constexpr int kUnit = static_cast<int>(kSpeedUnit_mmps);
  return {kUnit * signed_byte((argument >> 8) & 0xff), kUnit * signed_byte(argument & 0xff)};
}

}  // namespace caravan::bridge::arcos
