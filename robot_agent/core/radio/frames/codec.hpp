// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "robot_agent/core/radio/frames/messages.hpp"

namespace caravan::agent {

/// Why bytes are not a message of the protocol.
enum class DecodeError : std::uint8_t {
  kForeign,      ///< wrong first byte: another protocol or version
  kUnknownType,  ///< type not defined in this version
  kWrongLength,  ///< shorter or longer than the type requires
  kBadValue      ///< a field out of range
};

using Decoded = std::variant<Wait, Accept, AcceptAck, Reject, PathFragment, End, DecodeError>;

/// Accepts any bytes. A decoded message encodes to the same bytes again.
[[nodiscard]] Decoded decode(std::span<const std::uint8_t> bytes);

/// @pre the message conforms to docs/protocol.md, section "Frames"; at most 255 points
[[nodiscard]] std::vector<std::uint8_t> encode(const Message& message);

/// Number of points that fit into a PATH frame of `mtu_bytes`, at most 255; at least 1 if the MTU is 24 or
/// more.
[[nodiscard]] std::uint32_t points_that_fit(std::uint32_t mtu_bytes);

}  // namespace caravan::agent
