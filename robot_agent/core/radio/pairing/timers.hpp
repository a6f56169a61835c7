// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/types.hpp"

/// Timers of docs/protocol.md, section "Timers", that are not in the configuration.
namespace caravan::agent {

inline constexpr Time kSilence = std::chrono::seconds{2};        ///< a partner not heard for it is gone
inline constexpr Time kLinger = std::chrono::milliseconds{500};  ///< END is repeated for at most this long
inline constexpr Time kRest =
    std::chrono::seconds{1};  ///< after a failed attempt: drive on, pair with nobody
inline constexpr Time kHold = std::chrono::seconds{30};  ///< after a failed attempt: not with the same robot
inline constexpr Time kRejectPeriod = std::chrono::seconds{1};  ///< between two REJECTs to one robot
inline constexpr Time kSessionSlot =
    std::chrono::milliseconds{100};  ///< a session's number is its time in these
inline constexpr Time kRemember =
    std::chrono::milliseconds{200};  ///< a robot counts as near, when tuned away

}  // namespace caravan::agent
