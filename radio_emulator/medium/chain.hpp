// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "radio_emulator/medium/medium.hpp"
#include "runtime/pure/canonical_bytes.hpp"

namespace caravan::radio {

/// One step of the air for the radio's hash chain: what was sent and what arrived, as docs/digest.md orders
/// it.
///
/// @param stamp_ns       of the step, simulated time
/// @param transmissions  any order; they are written sorted by robot
/// @param receptions     as deliver() returned them
[[nodiscard]] pure::CanonicalBytes chain_link(std::int64_t stamp_ns,
                                              std::span<const Transmission> transmissions,
                                              std::span<const Reception> receptions);

}  // namespace caravan::radio
