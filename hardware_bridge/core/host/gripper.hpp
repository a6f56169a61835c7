// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// A gripper on the robot's user I/O port: commanded by command 33, observed by the digital inputs.
class ArcosGripper {
 public:
  /// @return the command packet, if the command has changed
  [[nodiscard]] std::optional<arcos::Bytes> want(bool closed, Time now) {
    if (wanted_ == closed) return std::nullopt;
    wanted_ = closed;
    told_ = now;
    return packet();
  }
  /// @return the packet again if the gripper has not obeyed within a second: it may have been lost
  [[nodiscard]] std::optional<arcos::Bytes> see(const arcos::Sip& sip, Time now) {
    if (!sip.digital_in) return std::nullopt;
    const std::uint8_t in = *sip.digital_in;
    const bool is_open = (in & arcos::kGripperNotOpen) == 0;
    const bool presses = (in & (arcos::kLeftPaddleFree | arcos::kRightPaddleFree)) == 0;
    holding_ = presses && (in & arcos::kInnerBeamBroken) != 0;
    if (!wanted_ || is_open != *wanted_ || now - told_ < std::chrono::seconds{1}) return std::nullopt;
    told_ = now;
    return packet();
  }
  /// True when something between the paddles breaks the beam, and both paddles press on it.
  [[nodiscard]] bool is_holding() const { return holding_; }
  /// A new connection: the robot may have lost the command.
  void restart() { wanted_.reset(); }

 private:
  [[nodiscard]] arcos::Bytes packet() const {
    return arcos::encode(arcos::Order::kGripper, *wanted_ ? arcos::kGripperCloses : arcos::kGripperOpens);
  }
  std::optional<bool> wanted_;
  Time told_{0};
  bool holding_ = false;
};

/// A simulated gripper for a robot without one: it holds an item after it has closed near the source, until
/// it opens. A person may load and unload the robot.
class ImaginedGripper {
 public:
  ImaginedGripper(const Point& source_W, double service_radius_m)
      : source_W_{source_W}, service_radius_m_{service_radius_m} {}

  void want(bool closed, const std::optional<Pose>& pose) {
    if (closed && !closed_ && pose) {
      holding_ =
          std::hypot(pose->p_WB.x_m - source_W_.x_m, pose->p_WB.y_m - source_W_.y_m) <= service_radius_m_;
    }
    if (!closed) holding_ = false;
    closed_ = closed;
  }
  [[nodiscard]] bool is_holding() const { return holding_; }

 private:
  Point source_W_;
  double service_radius_m_;
  bool closed_ = false;
  bool holding_ = false;
};

}  // namespace caravan::bridge
