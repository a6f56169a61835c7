// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"
#include "robot_agent/core/radio/settings.hpp"

namespace caravan::agent {

/// What a Communication goes by.
struct CommunicationSettings {
  RobotId id{1};
  SharingSettings sharing{};
  WaitSettings wait{};
  Air air{};
};

/// What the radio side of an agent needs to know in a step.
struct AirInputs {
  Time now{0};
  std::span<const ReceivedFrame> heard;
  /// The path to give: driven sections only. Empty: this robot has none (mode EXPLORE).
  const Path& own_path;
  /// Where this robot is and how it moves; told in WAIT.
  std::optional<Whereabouts> whereabouts{};
};

/// What it decides.
struct AirOutputs {
  std::vector<Frame> frames;  ///< WAIT first, then at most one negotiation or session frame, then rejections
  Channel tuned;
  bool stand_still = false;  ///< negotiating or in session: the robot must stop
  /// Another robot was heard in this step; one heard before is remembered for one WAIT period, and for 0.2 s
  /// while tuned away.
  bool robot_near = false;
  std::vector<Wait> robots;      ///< the WAITs heard in this step
  std::optional<Path> received;  ///< a partner's whole path, once, when it is complete
  std::vector<Exchange> ended;   ///< attempts that ended in this step
  std::uint32_t malformed = 0;   ///< frames heard in this step that are not of the protocol
};

/// The radio side of an agent: presence (WAIT), pairing (Algorithms 5 and 6) and path exchange.
/// docs/protocol.md is normative.
///
/// Presence works in every sharing mode; pairing begins at SharingSettings::starts. Whatever arrives, or does
/// not, it stands still for at most accept_attempts * accept_period + session_timer at a time.
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
