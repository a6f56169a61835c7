// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/arcos/reports.hpp"

#include "hardware_bridge/core/arcos/fields.hpp"

namespace caravan::bridge::arcos {
namespace {

constexpr std::uint8_t kEncoderType = 0x90;
constexpr std::uint8_t kGripperType = 0xe0;
constexpr std::uint8_t kIoType = 0xf0;
constexpr std::uint8_t kJoystickType = 0xf8;

void write_ticks(FieldWriter& out, std::int32_t ticks) {
  const auto bits = static_cast<std::uint32_t>(ticks);
  out.write(static_cast<std::uint16_t>(bits & 0xffffU));
  out.write(static_cast<std::uint16_t>(bits >> 16U));
}

}  // namespace

Bytes encode(const EncoderReport& report) {
  FieldWriter out;
  out.write(kEncoderType);
  write_ticks(out, report.left_ticks);
  write_ticks(out, report.right_ticks);
  return out.take();
}

Bytes encode(const IoReport& report) {
  FieldWriter out;
  out.write(kIoType);
  out.write(std::uint8_t{4});
  out.write(report.digital_in);
  out.write(report.front_bumpers);
  out.write(report.rear_bumpers);
  out.write(report.infrared);
  out.write(std::uint8_t{1});
  out.write(report.digital_out);
  out.write(static_cast<std::uint8_t>(report.analog.size()));
  for (const std::uint16_t input : report.analog) out.write(input);
  return out.take();
}

Bytes encode(const GripperReport& report) {
  FieldWriter out;
  out.write(kGripperType);
  out.write(report.type);
  out.write(report.state);
  out.write(report.grasp_time);
  return out.take();
}

Bytes encode(const JoystickReport& report) {
  FieldWriter out;
  out.write(kJoystickType);
  out.write(report.button_1);
  out.write(report.button_2);
  out.write(report.x);
  out.write(report.y);
  out.write(report.throttle);
  return out.take();
}

}  // namespace caravan::bridge::arcos
