// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"
#include "robot_agent/core/radio/settings.hpp"

namespace caravan::agent {

struct CommunicationSettings {
  RobotId id{1};
  SharingSettings sharing{};
  WaitSettings wait{};
  Air air{};
};

/// Inputs of the radio side in one step.
struct AirInputs {
  Time now{0};
  std::span<const ReceivedFrame> heard;
  /// The path to give: driven sections only. Empty: this robot has none (mode EXPLORE).
  const Path& own_path;
  /// Position and motion of this robot, to be reported in WAIT.
  std::optional<Whereabouts> whereabouts{};
};

/// Outputs of the radio side in one step.
struct AirOutputs {
  std::vector<Frame> frames;  ///< WAIT first, then at most one negotiation or session frame, then rejections
  Channel tuned;
  bool stand_still = false;  ///< the robot is negotiating or in session, and must stop
  /// Another robot was received in this step or recently: within one WAIT period, or within
  /// WaitSettings::remembered_away while tuned away.
  bool robot_near = false;
  std::vector<Wait> robots;      ///< WAITs received in this step
  std::optional<Path> received;  ///< the partner's whole path, once, when the exchange is complete
  std::vector<Exchange> ended;   ///< attempts that ended in this step
  std::uint32_t malformed = 0;   ///< received frames that are not of the protocol
};

/// The radio side of an agent: presence (WAIT), pairing (Algorithms 5 and 6) and exchange of paths.
/// docs/protocol.md is normative.
///
/// Presence works in every sharing mode; pairing begins at SharingSettings::starts. Whatever is received, the
/// robot stands still for at most accept_attempts * accept_period + session_timer at a time.
class Communication {
 public:
  explicit Communication(const CommunicationSettings& settings);
  ~Communication();
  Communication(Communication&&) noexcept;
  Communication& operator=(Communication&&) noexcept;

  [[nodiscard]] AirOutputs step(const AirInputs& inputs);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::agent
