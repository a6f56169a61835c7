// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/sharing_policy.hpp"
#include "runtime/pure/robot_model.hpp"

/// What a scenario can say of the agent's side of the radio. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// What the radio bears.
struct Air {
  std::uint32_t channel_count = robot_model::kChannelCount;
  std::uint32_t mtu_bytes = robot_model::kMtu_bytes;

  bool operator==(const Air&) const = default;
};

/// Presence: the WAIT frames.
struct WaitSettings {
  Time period{0};           ///< longest time between two; 0: every step
  bool tells_place = true;  ///< where the sender is and how it moves
  // One is sent sooner when the robot is not where others must take it to be by the last one.
  double stray_m = 0.1;
  double stray_rad = 0.3;
  Time stray_pause = std::chrono::milliseconds{100};      ///< but not sooner than this
  Time remembered_away = std::chrono::milliseconds{200};  ///< a robot that was heard, when tuned away

  bool operator==(const WaitSettings&) const = default;
};

/// Algorithms 5 to 7: with whom, when and how paths are exchanged. docs/protocol.md, section "Timers".
struct SharingSettings {
  Sharing mode = Sharing::kFull;
  bool stop_to_exchange = true;  ///< false: drives on while it negotiates and exchanges
  Time starts = std::chrono::minutes{15};
  Time recontact_after = std::chrono::minutes{10};
  Time accept_period = std::chrono::seconds{1};
  std::uint32_t accept_attempts = 8;
  Time session_timer = std::chrono::seconds{10};
  std::uint32_t points_per_frame = 20;
  Time silence = std::chrono::seconds{2};  ///< a partner not heard for it, and two WAIT periods, is gone
  Time linger = std::chrono::milliseconds{500};  ///< END is repeated for at most this long
  Time rest = std::chrono::seconds{1};           ///< after a failed attempt: drive on, pair with nobody
  Time hold = std::chrono::seconds{30};          ///< after a failed attempt: not with the same robot
  Time reject_period = std::chrono::seconds{1};  ///< between two REJECTs to one robot
  double merge_gain_m = 0.01;                    ///< a merged path that saves less is not worth a change

  bool operator==(const SharingSettings&) const = default;
};

}  // namespace caravan::agent
