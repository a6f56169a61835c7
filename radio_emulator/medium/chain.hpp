// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "radio_emulator/medium/medium.hpp"
#include "runtime/pure/hash_chain.hpp"

namespace caravan::radio {

/// Feeds one step of the air to the run's hash chain: what was sent and what arrived.
///
/// @param stamp_ns       of the step, simulated time
/// @param transmissions  any order; they are fed sorted by robot
/// @param receptions     as deliver() returned them
void chain_step(pure::HashChain& chain, std::int64_t stamp_ns, std::span<const Transmission> transmissions,
                std::span<const Reception> receptions);

}  // namespace caravan::radio
