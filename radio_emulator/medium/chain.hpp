// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "radio_emulator/medium/medium.hpp"
#include "runtime/pure/canonical_bytes.hpp"

namespace caravan::radio {

/// The data of one step of the medium for the radio's hash chain: transmissions and receptions, in the order
/// of docs/digest.md.
///
/// @param stamp_ns       simulated time of the step
/// @param transmissions  any order; they are written sorted by robot
/// @param receptions     as deliver() returned them
[[nodiscard]] pure::CanonicalBytes chain_link(std::int64_t stamp_ns,
                                              std::span<const Transmission> transmissions,
                                              std::span<const Reception> receptions);

}  // namespace caravan::radio
