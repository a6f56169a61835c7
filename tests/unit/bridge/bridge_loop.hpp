// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/robot/gps_receiver.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"

namespace caravan::bridge {

using namespace std::chrono_literals;

inline constexpr ArenaPlace kArena{48.1, 11.6, 0.4};
inline constexpr double kLoopRadius_m = 0.0975;
inline constexpr double kLoopTrack_m = 0.33;

inline BridgeConfig bridge_config() {
  BridgeConfig config;
  config.arena = kArena;
  return config;
}
inline RobotConfig robot_config() {
  RobotConfig config;
  config.arena = kArena;
  return config;
}

/// The bridge and an emulated robot at the two ends of a line, in simulated time. The tests of limits in
/// milliseconds use it.
class Loop : public ::testing::Test {
 protected:
  explicit Loop(const BridgeConfig& config = bridge_config(), const RobotConfig& robot = robot_config())
      : bridge_{config}, robot_{robot} {}

  void connect() {
    robot_.connected(now_);
    bridge_.robot_up(now_);
    run(2s);
  }
  void run(Time span) {
    for (const Time end = now_ + span; now_ < end;) step();
  }
  /// Advances both ends and the body between them by 10 ms.
  void step() {
    now_ += 10ms;
    const BodyDrive drive = robot_powered_ ? robot_.drive(now_) : BodyDrive{};
    moves_ = drive.left_mps != 0.0 || drive.right_mps != 0.0;
    move_body(drive);
    if (robot_powered_) robot_.sense(senses_, now_);
    const Point antenna{place_.x_m + gps_error_.x_m, place_.y_m + gps_error_.y_m};
    gps_.sense(gps_works_ ? antenna : Point{std::nan(""), 0.0}, now_);
    const std::string lines = change_gps_(gps_.take_lines(now_));
    if (gps_speaks_) bridge_.gps_says(bytes_of(lines), now_);
    if (robot_powered_ && !robot_silent_) pass_to_host(robot_.take_output());
    if (agent_speaks_ && frames_.size() >= answered_ + unanswered_) {
      if (!frames_.empty()) bridge_.wish(wish_, frames_.back().stamp, now_);
      answered_ = frames_.size();
    }
    bridge_.tick(now_);
    Bridge::Effects effects = bridge_.take_effects();
    if (line_whole_ && robot_hears_ && robot_powered_ && !effects.to_robot.empty()) {
      robot_.receive(effects.to_robot, now_);
    }
    unfit_ += effects.unfit;
    for (const Frame& frame : effects.frames) frames_.push_back(frame);
    for (const Notice& notice : effects.notices) told_ += notice.text + "\n";
    if (effects.reopen_robot && line_whole_) {
      robot_.connected(now_);
      bridge_.robot_up(now_);
    }
  }
  /// Time until the wheels have come to rest, `patience` at most.
  [[nodiscard]] Time rest_after(Time patience) {
    const Time began = now_;
    while (now_ - began < patience && (moves_ || now_ == began)) step();
    return now_ - began;
  }
  static std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  }
  void pass_to_host(const arcos::Bytes& bytes) {
    if (line_whole_ && !bytes.empty()) bridge_.robot_says(bytes, now_);
  }
  void move_body(const BodyDrive& drive) {
    senses_.left_wheel_rad += 0.01 * drive.left_mps / kLoopRadius_m;
    senses_.right_wheel_rad += 0.01 * drive.right_mps / kLoopRadius_m;
    const double turned = 0.01 * (drive.right_mps - drive.left_mps) / kLoopTrack_m;
    const double half_way = senses_.yaw_WB_rad + 0.5 * turned;
    place_.x_m += 0.005 * (drive.left_mps + drive.right_mps) * std::cos(half_way);
    place_.y_m += 0.005 * (drive.left_mps + drive.right_mps) * std::sin(half_way);
    senses_.yaw_WB_rad = wrapped(senses_.yaw_WB_rad + turned);
  }

  Bridge bridge_;
  Microcontroller robot_;
  GpsReceiver gps_{kArena};
  Time now_{0};
  BodySenses senses_;
  Point place_{3.0, -2.0};
  Wish wish_;
  bool moves_ = false;
  bool line_whole_ = true;
  bool robot_powered_ = true;
  bool robot_silent_ = false;
  bool robot_hears_ = true;
  bool gps_speaks_ = true;
  Point gps_error_;
  std::function<std::string(std::string)> change_gps_ = [](std::string lines) { return lines; };
  std::string unfit_;
  bool gps_works_ = true;
  bool agent_speaks_ = true;
  std::size_t unanswered_ = 0;  // frames between two answers of the agent; 0: it answers in every step
  std::size_t answered_ = 0;    // number of frames at the last answer
  std::vector<Frame> frames_;
  std::string told_;
};

class DrivingLoop : public Loop {
 protected:
  explicit DrivingLoop(const RobotConfig& robot = robot_config(),
                       const BridgeConfig& config = bridge_config())
      : Loop{config, robot} {}
  void SetUp() override {
    connect();
    wish_ = {0.5, 0.5, false};
    run(2s);
    ASSERT_TRUE(moves_);
  }
};

}  // namespace caravan::bridge
