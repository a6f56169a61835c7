// SPDX-License-Identifier: Apache-2.0
// What the microcontroller sends while its connection is open: SIPs, and the reports that a host requested.
#include <algorithm>
#include <utility>

#include "hardware_bridge/core/arcos/reports.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"

namespace caravan::bridge {
namespace {

constexpr std::size_t kArray = kSonarCount / 2;
constexpr double kMovesAbove_mmps = 5.0;
constexpr double kDegree = std::numbers::pi / 180.0;

std::uint16_t in_mm(double range_m) {
  if (!(range_m >= 0.0)) return 0;
  return static_cast<std::uint16_t>(std::lround(std::min(1000.0 * range_m, 1.0 * arcos::kNoEcho_mm)));
}

std::int32_t in_ticks(double way_m, std::uint16_t ticks_per_mm) {
  return static_cast<std::int32_t>(std::llround(1000.0 * way_m * ticks_per_mm));  // wraps
}

}  // namespace

void Microcontroller::tick(Time now) {
  if (!open_) return;
  motion_.hold(now - heard_ >= config_.watchdog);
  if (now - sip_due_ > config_.watchdog) sip_due_ = sonar_due_ = now;  // after a suspension: no backlog
  if (sonar_on_) {
    fire_sonars(now);
  } else {
    sonar_due_ = now;
  }
  if (now < sip_due_) return;
  send_with_sip(now);
  sip_due_ += config_.sip_period * ((now - sip_due_) / config_.sip_period + 1);
}

void Microcontroller::fire_sonars(Time now) {
  for (; sonar_due_ <= now; sonar_due_ += std::chrono::milliseconds{settings_.sonar_cycle_ms}) {
    for (const std::size_t array : {std::size_t{0}, kArray}) {
      const std::size_t index = array + next_sonar_;
      std::erase_if(fired_, [&](const arcos::Sip::Sonar& sonar) { return sonar.index == index; });
      fired_.push_back({static_cast<std::uint8_t>(index), in_mm(senses_.sonar_range_m[index])});
    }
    next_sonar_ = (next_sonar_ + 1) % kArray;
  }
}

void Microcontroller::send(std::span<const std::uint8_t> data) {
  const arcos::Bytes packet = arcos::to_packet(data);
  output_.insert(output_.end(), packet.begin(), packet.end());
}

void Microcontroller::send_with_sip(Time now) {
  if (joystick_asked_.take()) send(arcos::encode(arcos::JoystickReport{}));
  send_sip(now);
  if (encoders_asked_.take()) {
    send(arcos::encode(arcos::EncoderReport{in_ticks(reckoning_.left_m(), settings_.ticks_per_mm),
                                            in_ticks(reckoning_.right_m(), settings_.ticks_per_mm)}));
  }
  if (io_asked_.take()) {
    send(arcos::encode(arcos::IoReport{.digital_in = digital_in(),
                                       .front_bumpers = static_cast<std::uint8_t>(front_bumpers_),
                                       .rear_bumpers = static_cast<std::uint8_t>(rear_bumpers_),
                                       .digital_out = static_cast<std::uint8_t>(digital_out_)}));
  }
  if (gripper_asked_.take()) send(arcos::encode(arcos::GripperReport{.state = gripper_state()}));
}

void Microcontroller::send_sip(Time now) {
  arcos::Sip sip;
  reckoning_.write(sip);
  sip.moving = std::abs(sip.left_mmps) > kMovesAbove_mmps || std::abs(sip.right_mmps) > kMovesAbove_mmps;
  const auto decivolts =
      static_cast<std::uint16_t>(std::lround(std::clamp(10.0 * config_.battery_v, 0.0, 255.0)));
  sip.battery_dv = static_cast<std::uint8_t>(decivolts);
  sip.stall_and_bumpers = stall_and_bumpers(now);
  sip.control = heading_counts(motion_.heading_rad().value_or(reckoning_.yaw_rad()));
  sip.flags = flags();
  sip.compass = compass();
  sip.sonars = std::exchange(fired_, {});
  sip.gripper = gripper_state();
  sip.analog_port = analog_port_;
  sip.analog = std::uint8_t{0};
  sip.digital_in = digital_in();
  sip.digital_out = static_cast<std::uint8_t>(digital_out_);
  sip.battery_fine_dv = decivolts;
  sip.charge = std::uint8_t{0};
  const double turn_radps = (reckoning_.right_mps() - reckoning_.left_mps()) / config_.track_m;
  sip.turn_rate =
      static_cast<std::int16_t>(std::lround(std::clamp(10.0 * turn_radps / kDegree, -32767.0, 32767.0)));
  sip.fault = std::uint16_t{0};
  send(arcos::encode(sip));
}

std::uint16_t Microcontroller::stall_and_bumpers(Time now) const {
  const bool both = bump_stalled_ || (stop_pressed_ && stop_stalls_);
  unsigned bits = front_bumpers_ << arcos::kFrontBumperShift | rear_bumpers_ << arcos::kRearBumperShift;
  if (both || left_stall_.stalls(now)) bits |= arcos::kLeftStall;
  if (both || right_stall_.stalls(now)) bits |= arcos::kRightStall;
  return static_cast<std::uint16_t>(bits);
}

std::uint16_t Microcontroller::flags() const {
  unsigned bits = 0;
  if (motors_on_) bits |= arcos::kMotorsOn;
  if (sonar_on_) bits |= arcos::kSonarsOn;
  if (stop_pressed_) bits |= arcos::kStopPressed;
  if (stop_pressed_ && stop_stalls_) bits |= arcos::kStopStalls;
  return static_cast<std::uint16_t>(bits);
}

std::uint8_t Microcontroller::compass() const {
  const double bearing = projection_.bearing_of_yaw(senses_.yaw_WB_rad) - config_.compass_offset_rad;
  return static_cast<std::uint8_t>(std::lround(0.5 * (bearing / kDegree + 720.0)) % 180);
}

std::uint8_t Microcontroller::digital_in() const {
  unsigned in = 0;
  if (gripper_closed_) in |= arcos::kGripperNotOpen;
  if (senses_.holding) in |= arcos::kInnerBeamBroken;
  if (!gripper_closed_) in |= arcos::kLeftPaddleFree | arcos::kRightPaddleFree;
  return static_cast<std::uint8_t>(in);
}

std::uint8_t Microcontroller::gripper_state() const {
  return gripper_closed_ ? arcos::kPaddlesClosed : arcos::kPaddlesOpen;
}

}  // namespace caravan::bridge
