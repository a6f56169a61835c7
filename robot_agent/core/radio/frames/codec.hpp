// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "robot_agent/core/radio/frames/messages.hpp"

namespace caravan::agent {

/// Why bytes are no message of ours.
enum class DecodeError : std::uint8_t {
  kForeign,      ///< not our first byte: another protocol or version
  kUnknownType,  ///< a type that this version does not have
  kWrongLength,  ///< shorter or longer than its type says
  kBadValue      ///< a field outside its range
};

using Decoded = std::variant<Wait, Accept, AcceptAck, Reject, PathFragment, End, DecodeError>;

/// Any bytes are allowed. What decodes encodes to the same bytes again.
[[nodiscard]] Decoded decode(std::span<const std::uint8_t> bytes);

/// @pre the message obeys docs/protocol.md, section "Frames"; at most 255 points
[[nodiscard]] std::vector<std::uint8_t> encode(const Message& message);

/// How many points a PATH frame of at most `mtu_bytes` holds; at least 1 from an MTU of 24.
[[nodiscard]] std::uint32_t points_that_fit(std::uint32_t mtu_bytes);

}  // namespace caravan::agent
