// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "hardware_bridge/core/robot/microcontroller.hpp"

namespace caravan::bridge {

using namespace std::chrono_literals;

/// Bytes from their notation in hexadecimal: "FA FB 03".
inline arcos::Bytes from_hex(const std::string& text) {
  arcos::Bytes bytes;
  std::istringstream in{text};
  for (unsigned byte = 0; in >> std::hex >> byte;) bytes.push_back(static_cast<std::uint8_t>(byte));
  return bytes;
}

/// An emulated robot without a world. The test is its host and turns its wheels as its motors command.
class RobotBench : public ::testing::Test {
 protected:
  static constexpr double kRadius_m = 0.0975;

  explicit RobotBench(const RobotConfig& config = {}) : robot_{config} {}

  void say(const arcos::Bytes& packet) { robot_.receive(packet, now_); }
  void say(const std::string& hex) { say(from_hex(hex)); }
  void say(arcos::Order order, int argument) { say(encode(order, argument)); }
  /// Opens the robot and sends no further command.
  void shake_hands() {
    robot_.connected(now_);
    for (const arcos::Order order :
         {arcos::Order::kPulse, arcos::Order::kOpen, arcos::Order::kClose, arcos::Order::kOpen}) {
      say(encode(order));
    }
    (void)robot_.take_output();
  }
  /// Opens the robot and switches its motors and sonars on.
  void open() {
    shake_hands();
    say(arcos::Order::kEnable, 1);
    say(arcos::Order::kSonar, 1);
  }
  /// Turns the wheels as commanded for `span`, and sends PULSE as any host does. With `grip` 0 the wheels are
  /// blocked.
  void run_with_pulses(Time span, double grip = 1.0) {
    for (const Time end = now_ + span; now_ < end;) {
      say(encode(arcos::Order::kPulse));
      run(std::min<Time>(500ms, end - now_), grip);
    }
  }
  void run(Time span, double grip = 1.0) {
    for (const Time end = now_ + span; now_ < end;) {
      now_ += 10ms;
      drive_ = robot_.drive(now_);
      fastest_mps_ = std::max(fastest_mps_, 0.5 * std::abs(drive_.left_mps + drive_.right_mps));
      fastest_turn_radps_ =
          std::max(fastest_turn_radps_, std::abs(drive_.right_mps - drive_.left_mps) / 0.33);
      senses_.left_wheel_rad += grip * 0.01 * drive_.left_mps / kRadius_m;
      senses_.right_wheel_rad += grip * 0.01 * drive_.right_mps / kRadius_m;
      robot_.sense(senses_, now_);
      for (arcos::Bytes& data : packets_.feed(robot_.take_output())) {
        if (auto sip = arcos::decode_sip(data)) sips_.push_back(std::move(*sip));
        packets_seen_.push_back(std::move(data));
      }
    }
  }
  [[nodiscard]] double left_m() const { return senses_.left_wheel_rad * kRadius_m; }
  [[nodiscard]] double right_m() const { return senses_.right_wheel_rad * kRadius_m; }
  [[nodiscard]] double travelled_m() const { return 0.5 * (left_m() + right_m()); }
  [[nodiscard]] double turned_deg() const { return (right_m() - left_m()) / 0.33 * 180.0 / std::numbers::pi; }
  /// The answer to CONFIG.
  [[nodiscard]] arcos::Settings settings() {
    (void)robot_.take_output();
    say(encode(arcos::Order::kConfig));
    arcos::PacketFinder finder;
    for (const arcos::Bytes& data : finder.feed(robot_.take_output())) {
      if (auto found = arcos::decode_settings(data)) return *found;
    }
    ADD_FAILURE() << "no answer to CONFIG";
    return {};
  }
  /// Number of packets of a type since the last call, for any type.
  [[nodiscard]] int take_count(std::uint8_t type) {
    const auto count = std::count_if(packets_seen_.begin(), packets_seen_.end(),
                                     [&](const arcos::Bytes& data) { return data[0] == type; });
    packets_seen_.clear();
    return static_cast<int>(count);
  }

  /// The newest packet of a type; empty if none has come.
  [[nodiscard]] arcos::Bytes last(std::uint8_t type) const {
    const auto found = std::find_if(packets_seen_.rbegin(), packets_seen_.rend(),
                                    [&](const arcos::Bytes& data) { return data[0] == type; });
    return found == packets_seen_.rend() ? arcos::Bytes{} : *found;
  }

  Microcontroller robot_;
  Time now_{0};
  BodySenses senses_;
  BodyDrive drive_;
  double fastest_mps_ = 0.0;
  double fastest_turn_radps_ = 0.0;
  arcos::PacketFinder packets_;
  std::vector<arcos::Sip> sips_;
  std::vector<arcos::Bytes> packets_seen_;
};

}  // namespace caravan::bridge
