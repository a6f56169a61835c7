// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/microcontroller.hpp"

#include <algorithm>
#include <utility>

namespace caravan::bridge {

using arcos::Order;

namespace {

constexpr std::size_t kArray = kSonarCount / 2;
constexpr std::uint8_t kThirdSync = 2;
constexpr const char* kRobotType = "Pioneer";

std::uint16_t in_mm(double range_m) {
  if (!(range_m >= 0.0)) return 0;
  return static_cast<std::uint16_t>(std::lround(std::min(1000.0 * range_m, 1.0 * arcos::kNoEcho_mm)));
}

}  // namespace

Microcontroller::Microcontroller(const RobotConfig& config)
    : config_{config},
      projection_{config.arena},
      reckoning_{arcos::factors_of(config.subtype).value_or(arcos::Factors{}), config.track_m,
                 config.wheel_radius_m},
      ramp_{config.track_m} {}

void Microcontroller::connected(Time now) {
  disconnected();
  connected_ = true;
  heard_ = now;
}

void Microcontroller::disconnected() {
  connected_ = synchronised_ = open_ = motors_on_ = sonar_on_ = false;
  ramp_.halt();
  packets_.restart();
  output_.clear();
}

void Microcontroller::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (!connected_) return;
  for (const arcos::Bytes& data : packets_.feed(bytes)) {
    heard_ = now;
    if (const auto command = arcos::decode_command(data)) {
      obey(*command, now);
    } else {
      ++ignored_;
    }
  }
}

void Microcontroller::obey(const arcos::Command& command, Time now) {
  if (!open_ && std::holds_alternative<std::monostate>(command.argument) && command.number <= kThirdSync) {
    // OPEN is the same packet as SYNC1: it is OPEN once all three have been answered.
    if (command.number == static_cast<std::uint8_t>(Order::kOpen) && synchronised_) {
      open_ = true;
      sip_due_ = sonar_due_ = now;
      return;
    }
    answer_sync(command.number);
    return;
  }
  if (!open_) {
    ++ignored_;
    return;
  }
  switch (static_cast<Order>(command.number)) {
    case Order::kPulse:
      break;
    case Order::kClose:
      open_ = synchronised_ = motors_on_ = sonar_on_ = false;
      ramp_.halt();
      break;
    case Order::kStop:
      ramp_.want_stop();
      break;
    case Order::kEmergencyStop:
      ramp_.halt();
      break;
    default:
      obey_number(static_cast<Order>(command.number), command);
  }
}

void Microcontroller::obey_number(Order order, const arcos::Command& command) {
  const int* given = std::get_if<int>(&command.argument);
  const int argument = given == nullptr ? 0 : *given;
  switch (order) {
    case Order::kEnable:
      motors_on_ = argument != 0 && !stop_pressed_;
      if (!motors_on_) ramp_.halt();
      break;
    case Order::kSetAcceleration:
      return ramp_.set_acceleration(argument);
    case Order::kSetMaxSpeed:
      return ramp_.set_max_speed(argument);
    case Order::kSetOrigin:
      return reckoning_.set_origin();
    case Order::kSpeed:
      return ramp_.want_speed(argument);
    case Order::kHeading:
      return ramp_.want_heading(argument);
    case Order::kTurnRate:
      return ramp_.want_turn_rate(argument);
    case Order::kWheelSpeeds:
      return ramp_.want_wheels(arcos::wheel_speeds_of(argument));
    case Order::kSonar:
      sonar_on_ = argument != 0;
      break;
    case Order::kConfig:
      return send(arcos::encode(settings()));
    case Order::kGripper:
      if (argument == arcos::kGripperOpens || argument == arcos::kGripperCloses) {
        gripper_closed_ = argument == arcos::kGripperCloses;
      }
      break;
    default:
      ++ignored_;
  }
}

void Microcontroller::answer_sync(std::uint8_t number) {
  synchronised_ = number == kThirdSync;
  if (synchronised_) {
    send(arcos::encode(arcos::Names{config_.name, kRobotType, config_.subtype}));
  } else {
    send(std::array{number});
  }
}

arcos::Settings Microcontroller::settings() const {
  return {.type = kRobotType,
          .subtype = config_.subtype,
          .serial_number = "0",
          .top_turn_degps = WheelRamp::kTopTurn_degps,
          .top_speed_mmps = WheelRamp::kTopSpeed_mmps,
          .name = config_.name,
          .sip_period_ms = static_cast<std::uint8_t>(config_.sip_period / std::chrono::milliseconds{1}),
          .gripper = 1,
          .front_sonar = 1,
          .rear_sonar = 1,
          .watchdog_ms = static_cast<std::uint16_t>(config_.watchdog / std::chrono::milliseconds{1})};
}

void Microcontroller::send(std::span<const std::uint8_t> data) {
  const arcos::Bytes packet = arcos::to_packet(data);
  output_.insert(output_.end(), packet.begin(), packet.end());
}

void Microcontroller::sense(const BodySenses& senses, Time now) {
  senses_ = senses;
  reckoning_.turn(senses.left_wheel_rad, senses.right_wheel_rad, now);
  ramp_.see(reckoning_.left_mps(), reckoning_.right_mps(), now);
  tick(now);
}

void Microcontroller::fire_sonars(Time now) {
  for (; sonar_due_ <= now; sonar_due_ += config_.sonar_period) {
    for (const std::size_t array : {std::size_t{0}, kArray}) {
      const std::size_t index = array + next_sonar_;
      std::erase_if(fired_, [&](const arcos::Sip::Sonar& sonar) { return sonar.index == index; });
      fired_.push_back({static_cast<std::uint8_t>(index), in_mm(senses_.sonar_range_m[index])});
    }
    next_sonar_ = (next_sonar_ + 1) % kArray;
  }
}

void Microcontroller::tick(Time now) {
  if (!open_) return;
  if (now - heard_ >= config_.watchdog) ramp_.want_stop();
  if (now - sip_due_ > config_.watchdog)
    sip_due_ = sonar_due_ = now;  // it has slept: nothing is caught up with
  if (sonar_on_) {
    fire_sonars(now);
  } else {
    sonar_due_ = now;
  }
  if (now < sip_due_) return;
  send_sip(now);
  sip_due_ += config_.sip_period * ((now - sip_due_) / config_.sip_period + 1);
}

void Microcontroller::send_sip(Time now) {
  arcos::Sip sip;
  reckoning_.write(sip);
  sip.moving = std::abs(sip.left_mmps) > 5 || std::abs(sip.right_mmps) > 5;
  const auto decivolts =
      static_cast<std::uint16_t>(std::lround(std::clamp(10.0 * config_.battery_v, 0.0, 255.0)));
  sip.battery_dv = static_cast<std::uint8_t>(decivolts);
  if (ramp_.left_stalls(now)) sip.stall_and_bumpers |= arcos::kLeftStall;
  if (ramp_.right_stalls(now)) sip.stall_and_bumpers |= arcos::kRightStall;
  if (motors_on_) sip.flags |= arcos::kMotorsOn;
  if (stop_pressed_) sip.flags |= arcos::kStopPressed;
  const double bearing = projection_.bearing_of_yaw(senses_.yaw_WB_rad) - config_.compass_offset_rad;
  const double bearing_deg = bearing * 180.0 / std::numbers::pi + 720.0;
  sip.compass = static_cast<std::uint8_t>(std::lround(0.5 * bearing_deg) % 180);
  sip.sonars = std::exchange(fired_, {});
  sip.gripper = std::uint8_t{0};
  sip.analog_port = sip.analog = std::uint8_t{0};
  sip.digital_in = digital_in();
  sip.digital_out = std::uint8_t{0};
  sip.battery_fine_dv = decivolts;
  send(arcos::encode(sip));
}

std::uint8_t Microcontroller::digital_in() const {
  unsigned in = 0;
  if (gripper_closed_) in |= arcos::kGripperNotOpen;
  if (senses_.holding) in |= arcos::kInnerBeamBroken;
  if (!gripper_closed_) in |= arcos::kLeftPaddleFree | arcos::kRightPaddleFree;
  return static_cast<std::uint8_t>(in);
}

BodyDrive Microcontroller::drive(Time now) {
  tick(now);
  const WheelRamp::Speeds speeds = ramp_.at(now, reckoning_.yaw_rad());
  const bool drives = open_ && motors_on_;
  return {drives ? speeds.left_mps : 0.0, drives ? speeds.right_mps : 0.0, gripper_closed_};
}

arcos::Bytes Microcontroller::take_output() { return std::exchange(output_, {}); }

void Microcontroller::press_stop(bool pressed) {
  stop_pressed_ = pressed;
  if (pressed) switch_motors(false);
}

void Microcontroller::switch_motors(bool on) {
  motors_on_ = on && open_ && !stop_pressed_;
  if (!motors_on_) ramp_.halt();
}

}  // namespace caravan::bridge
