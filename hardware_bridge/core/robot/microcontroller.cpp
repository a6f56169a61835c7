// SPDX-License-Identifier: Apache-2.0
// How the microcontroller handles a host's commands. What it sends: microcontroller_sip.cpp.
#include "hardware_bridge/core/robot/microcontroller.hpp"

#include <utility>

#include "hardware_bridge/core/robot/tuning.hpp"

namespace caravan::bridge {

using arcos::Order;

namespace {

constexpr std::uint8_t kThirdSync = 2;
constexpr double kMillimetre = 0.001;
constexpr double kDegree = std::numbers::pi / 180.0;

constexpr int kFrontBumps = 1;  // in the argument of BUMPSTALL
constexpr int kRearBumps = 2;

arcos::Settings settings_of(const RobotConfig& config) {
  using std::chrono::milliseconds;
  return {.subtype = config.subtype,
          .serial_number = "0",
          .name = config.name,
          .sip_period_ms = static_cast<std::uint8_t>(config.sip_period / milliseconds{1}),
          .gripper = 1,
          .watchdog_ms = static_cast<std::uint16_t>(config.watchdog / milliseconds{1}),
          .front_bumpers = config.front_bumpers,
          .rear_bumpers = config.rear_bumpers,
          .sonar_cycle_ms = static_cast<std::uint8_t>(config.sonar_period / milliseconds{1}),
          .firmware = "2.9"};
}

}  // namespace

Microcontroller::Microcontroller(const RobotConfig& config)
    : config_{config},
      projection_{config.arena},
      settings_{settings_of(config)},
      reckoning_{arcos::factors_of(config.subtype).value_or(arcos::Factors{}), config.track_m,
                 config.wheel_radius_m},
      motion_{config.track_m} {}

void Microcontroller::connected(Time now) {
  disconnected();
  connected_ = true;
  heard_ = now;
  unknown_.clear();
  malformed_.clear();
}

void Microcontroller::disconnected() {
  close();
  connected_ = false;
  packets_.restart();
  output_.clear();
}

void Microcontroller::close() {
  open_ = synchronised_ = motors_on_ = sonar_on_ = false;
  motion_.halt();
  settings_ = settings_of(config_);
  stop_stalls_ = true;
  bump_stall_ = kFrontBumps | kRearBumps;
  encoders_asked_ = io_asked_ = gripper_asked_ = joystick_asked_ = ReportRequest{};
}

void Microcontroller::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (!connected_) return;
  for (const arcos::Bytes& data : packets_.feed(bytes)) {
    heard_ = now;
    if (const auto command = arcos::decode_command(data)) {
      obey(*command, now);
    } else {
      ++ignored_;
      malformed_.insert(data[0]);
    }
  }
}

void Microcontroller::obey(const arcos::Command& command, Time now) {
  if (!open_) return shake_hands(command, now);
  const auto order = static_cast<Order>(command.number);
  const int value = arcos::number_of(command);
  if (order == Order::kPulse || order == Order::kOpen) return;
  if (order == Order::kClose) return close();
  if (order == Order::kConfig) return send(arcos::encode(settings_));
  if (move(order, value) || tune(settings_, order, value) || switch_on_or_off(order, value) ||
      ask_for_report(order, value)) {
    return;
  }
  ++ignored_;
  unknown_.insert(command.number);
}

void Microcontroller::shake_hands(const arcos::Command& command, Time now) {
  // OPEN without an argument is the same packet as SYNC1. It means OPEN once all three syncs have been
  // answered.
  if (command.number == static_cast<std::uint8_t>(Order::kOpen) && synchronised_) {
    open_ = sonar_on_ = true;
    sip_due_ = sonar_due_ = now;
    return;
  }
  // A sync has no argument. CLOSE with an argument is not SYNC2: a host sends it to start anew.
  const bool is_sync =
      command.number <= kThirdSync && std::holds_alternative<std::monostate>(command.argument);
  if (is_sync) return answer_sync(command.number);
  if (command.number == static_cast<std::uint8_t>(Order::kClose)) return close();
  ++ignored_;
}

void Microcontroller::answer_sync(std::uint8_t number) {
  synchronised_ = number == kThirdSync;
  if (synchronised_) {
    send(arcos::encode(arcos::Names{settings_.name, settings_.type, settings_.subtype}));
  } else {
    send(std::array{number});
  }
}

bool Microcontroller::move(Order order, int value) {
  switch (order) {
    case Order::kStop:
      motion_.want_stop();
      break;
    case Order::kEmergencyStop:
      motion_.halt();
      break;
    case Order::kMove:
      motion_.want_distance(kMillimetre * value, place());
      break;
    case Order::kSpeed:
      motion_.want_speed(kMillimetre * value);
      break;
    case Order::kHeading:
      motion_.want_heading(kDegree * value);
      break;
    case Order::kHeadingFromHere:
      motion_.want_heading(reckoning_.yaw_rad() + kDegree * value);
      break;
    case Order::kHeadingFromSetpoint:
      motion_.want_heading(motion_.heading_rad().value_or(reckoning_.yaw_rad()) + kDegree * value);
      break;
    case Order::kTurnRate:
    case Order::kRotate:
      motion_.want_turn_rate(kDegree * value);
      break;
    case Order::kWheelSpeeds: {
      const arcos::WheelSpeeds speeds = arcos::wheel_speeds_of(value);
      motion_.want_wheels(kMillimetre * speeds.left_mmps, kMillimetre * speeds.right_mmps);
      break;
    }
    default:
      return false;
  }
  if (!motors_on_) motion_.halt();  // a motion command must not wait for ENABLE
  return true;
}

bool Microcontroller::switch_on_or_off(Order order, int value) {
  switch (order) {
    case Order::kEnable:
      switch_motors(value != 0);
      return true;
    case Order::kSetOrigin:
      motion_.turn_origin(reckoning_.yaw_rad());
      reckoning_.set_origin();
      return true;
    case Order::kSonar:
      sonar_on_ = value != 0;
      return true;
    case Order::kBumpStall:
      bump_stall_ = value;
      return true;
    case Order::kStopButtonStalls:
      stop_stalls_ = value != 0;
      return true;
    case Order::kGripper:
      if (value == arcos::kGripperOpens || value == arcos::kGripperCloses) {
        gripper_closed_ = value == arcos::kGripperCloses;
      }
      return true;
    case Order::kDigitalOut: {
      const unsigned bits = static_cast<unsigned>(value) >> 8U & 0xffU;
      digital_out_ = (digital_out_ & ~bits) | (static_cast<unsigned>(value) & bits);
      return true;
    }
    case Order::kAnalogSelect:
      analog_port_ = static_cast<std::uint8_t>(value);
      return true;
    default:
      return false;
  }
}

bool Microcontroller::ask_for_report(Order order, int value) {
  switch (order) {
    case Order::kEncoderRequest:
      encoders_asked_.ask(value);
      return true;
    case Order::kIoRequest:
      io_asked_.ask(value);
      return true;
    case Order::kGripperRequest:
      gripper_asked_.ask(value);
      return true;
    case Order::kJoystickRequest:
      joystick_asked_.ask(value);
      return true;
    case Order::kImuRequest:  // A Pioneer 3-DX as delivered has no inertial sensors, no gyro and no batteries
    case Order::kGyro:        // that report their state: it sends no answer. A line on TCP has no baud rate.
    case Order::kBatteryRequest:
    case Order::kHostBaud:
      return true;
    default:
      return false;
  }
}

void Microcontroller::sense(const BodySenses& senses, Time now) {
  senses_ = senses;
  reckoning_.turn(senses.left_wheel_rad, senses.right_wheel_rad, senses.measured.value_or(now));
  left_stall_.see(told_.left_mps, reckoning_.left_mps(), now);
  right_stall_.see(told_.right_mps, reckoning_.right_mps(), now);
  tick(now);
}

void Microcontroller::stop_at_bumpers() {
  const double ahead = motion_.wanted_ahead_mps(place());
  const bool bumps = (ahead > 0.0 && front_bumpers_ != 0 && (bump_stall_ & kFrontBumps) != 0) ||
                     (ahead < 0.0 && rear_bumpers_ != 0 && (bump_stall_ & kRearBumps) != 0);
  if (bumps) {
    motion_.halt();
    bump_stalled_ = true;
  } else if (ahead != 0.0 || (front_bumpers_ | rear_bumpers_) == 0) {
    bump_stalled_ = false;
  }
}

BodyDrive Microcontroller::drive(Time now) {
  tick(now);
  stop_at_bumpers();
  motion_.set_limits(limits_of(settings_));
  const MotionControl::Speeds speeds = motion_.at(now, place());
  told_ = open_ && motors_on_ ? speeds : MotionControl::Speeds{};
  return {told_.left_mps, told_.right_mps, gripper_closed_};
}

arcos::Bytes Microcontroller::take_output() { return std::exchange(output_, {}); }

void Microcontroller::press_stop(bool pressed) {
  stop_pressed_ = pressed;
  if (pressed) switch_motors(false);
}

void Microcontroller::switch_motors(bool on) {
  motors_on_ = on && open_ && !stop_pressed_;
  if (!motors_on_) motion_.halt();
}

void Microcontroller::press_bumpers(unsigned front, unsigned rear) {
  front_bumpers_ = front & ((1U << config_.front_bumpers) - 1U);
  rear_bumpers_ = rear & ((1U << config_.rear_bumpers) - 1U);
}

}  // namespace caravan::bridge
