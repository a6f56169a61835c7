// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "tests/system/support/bus_player.hpp"

namespace caravan::test {

/// The test in place of the agent of a robot: answers every frame with a command of its choice.
class PlayedAgent {
 public:
  using Frame = caravan_interfaces::msg::SensorFrame;
  using Command = caravan_interfaces::msg::RobotCommand;
  /// Fills in the command; its stamp and session are already set. @return false: send no answer
  using Choose = std::function<bool(const Frame& frame, Command& command)>;

  PlayedAgent(const runtime::BusConfig& bus, std::uint32_t robot, Choose choose)
      : choose_{std::move(choose)}, bus_{bus} {
    commands_ = bus_.writer<caravan_interfaces::msg::RobotCommandPubSubType>(idl::kCommand, robot);
    bus_.reader<caravan_interfaces::msg::SensorFramePubSubType>(
        idl::kSensors, robot, [this](const Frame& frame, const runtime::ParticipantId&) { answer(frame); });
  }

  [[nodiscard]] std::vector<Frame> frames() const {
    const std::lock_guard lock{mutex_};
    return frames_;
  }
  void choose(Choose choose) {
    const std::lock_guard lock{mutex_};
    choose_ = std::move(choose);
  }

 private:
  void answer(const Frame& frame) {
    const std::lock_guard lock{mutex_};
    frames_.push_back(frame);
    Command command;
    command.stamp(frame.stamp());
    command.session(frame.session());
    if (choose_(frame, command)) commands_.write(command);
  }

  mutable std::mutex mutex_;
  Choose choose_;
  std::vector<Frame> frames_;
  runtime::Writer<caravan_interfaces::msg::RobotCommandPubSubType> commands_;
  runtime::Bus bus_;  // last, so that no callback outlives the rest
};

/// Always commands these speeds.
[[nodiscard]] inline PlayedAgent::Choose drives(double left_mps, double right_mps) {
  return [=](const PlayedAgent::Frame&, PlayedAgent::Command& command) {
    command.left_mps(left_mps);
    command.right_mps(right_mps);
    return true;
  };
}

}  // namespace caravan::test
