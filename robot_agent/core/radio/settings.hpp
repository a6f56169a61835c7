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

  bool operator==(const WaitSettings&) const = default;
};

/// Algorithms 5 to 7: with whom, when and how paths are exchanged.
struct SharingSettings {
  Sharing mode = Sharing::kFull;
  bool stop_to_exchange = true;  ///< false: drives on while it negotiates and exchanges
  Time starts = std::chrono::minutes{15};
  Time recontact_after = std::chrono::minutes{10};
  Time accept_period = std::chrono::seconds{1};
  std::uint32_t accept_attempts = 8;
  Time session_timer = std::chrono::seconds{10};
  std::uint32_t points_per_frame = 20;

  bool operator==(const SharingSettings&) const = default;
};

}  // namespace caravan::agent
