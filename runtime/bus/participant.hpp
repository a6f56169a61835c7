// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>

#include "runtime/bus/identity.hpp"
#include "runtime/bus/role.hpp"

namespace caravan::runtime {

/// A participant on the bus: its GUID prefix.
struct ParticipantId {
  std::array<std::uint8_t, 12> prefix{};
  auto operator<=>(const ParticipantId&) const = default;
};

/// The writer of a sample, and its claim to write the topic.
struct Sender : ParticipantId {
  Claim claim = Claim::kNone;
};

/// The GUID prefix as DDS tools print it: 01.0f.3a. and so on.
[[nodiscard]] std::string to_text(const ParticipantId& id);
/// One of our processes by role, process id and host; any other participant by its GUID and its stated
/// identity.
[[nodiscard]] std::string to_text(const ParticipantId& id, const Identity& identity);

}  // namespace caravan::runtime
