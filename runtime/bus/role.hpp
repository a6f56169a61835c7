// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "idl/topics.hpp"
#include "runtime/bus/identity.hpp"

namespace caravan::runtime {

/// The role that a participant states in its name; none: it is not one of our processes.
[[nodiscard]] std::optional<idl::Party> stated_role(const Identity& identity);

/// A participant's claim to write a topic.
enum class Claim : std::uint8_t {
  kNone,  ///< its samples are refused
  kWeak,  ///< it states no role: a bridge of any make. Yields to a process that states the role
  kFull   ///< it states the role, or is the agent of a robot, which may be any program
};

/// Topics of the world, of the radio and of observers need a stated role; those of a robot do not.
[[nodiscard]] Claim claim_of(const idl::Topic& topic, const Identity& identity);

}  // namespace caravan::runtime
