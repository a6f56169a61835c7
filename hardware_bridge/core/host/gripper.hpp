// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// A gripper on the robot's user I/O port: told by command 33, seen in the digital inputs.
class ArcosGripper {
 public:
  /// @return the packet that makes it so, when that is not what it was told last
  [[nodiscard]] std::optional<arcos::Bytes> want(bool closed, Time now) {
    if (wanted_ == closed) return std::nullopt;
    wanted_ = closed;
    told_ = now;
    return packet();
  }
  /// @return the packet again, when the gripper has not obeyed for a second: it may have been lost
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
  /// Something between the paddles breaks the beam and both press on it.
  [[nodiscard]] bool is_holding() const { return holding_; }
  /// Another connection: the robot may have forgotten.
  void restart() { wanted_.reset(); }

 private:
  [[nodiscard]] arcos::Bytes packet() const {
    return arcos::encode(arcos::Order::kGripper, *wanted_ ? arcos::kGripperCloses : arcos::kGripperOpens);
  }
  std::optional<bool> wanted_;
  Time told_{0};
  bool holding_ = false;
};

/// For a robot without a gripper: an imagined one, that has an item when it closed near the source and none
/// once it has opened. Somebody on the field may load and unload.
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
