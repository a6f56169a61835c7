// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/sharing_policy.hpp"
#include "runtime/pure/robot_model.hpp"

/// Parameters of the agent's side of the radio. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// Limits of the radio.
struct Air {
  std::uint32_t channel_count = robot_model::kChannelCount;
  std::uint32_t mtu_bytes = robot_model::kMtu_bytes;

  bool operator==(const Air&) const = default;
};

/// Presence: the WAIT frames.
struct WaitSettings {
  Time period{0};           ///< longest time between two; 0: every step
  bool tells_place = true;  ///< position, heading and twist of the sender
  double stray_m = 0.1;     ///< error of the reported position that causes an early WAIT
  double stray_rad = 0.3;   ///< the same of the heading
  Time stray_pause = std::chrono::milliseconds{100};      ///< shortest time before an early WAIT
  Time remembered_away = std::chrono::milliseconds{200};  ///< near for this time while tuned away

  bool operator==(const WaitSettings&) const = default;
};

/// Algorithms 5 to 7: with which robot, when and how paths are exchanged. Timers: docs/protocol.md, section
/// "Timers".
struct SharingSettings {
  Sharing mode = Sharing::kFull;
  bool stop_to_exchange = true;  ///< false: drives on while it negotiates and exchanges
  Time starts = std::chrono::minutes{15};
  Time recontact_after = std::chrono::minutes{10};
  Time accept_period = std::chrono::seconds{1};
  std::uint32_t accept_attempts = 8;
  Time session_timer = std::chrono::seconds{10};
  std::uint32_t points_per_frame = 20;
  Time silence = std::chrono::seconds{2};        ///< of a partner that counts as gone, plus two WAIT periods
  Time linger = std::chrono::milliseconds{500};  ///< longest time in which END is repeated
  Time rest = std::chrono::seconds{1};           ///< after a failed attempt: no pairing with any robot
  Time hold = std::chrono::seconds{30};          ///< after a failed attempt: no pairing with the same robot
  Time reject_period = std::chrono::seconds{1};  ///< between two REJECTs to one robot
  double merge_gain_m = 0.01;                    ///< smallest gain for which a merged path is adopted

  bool operator==(const SharingSettings&) const = default;
};

}  // namespace caravan::agent
