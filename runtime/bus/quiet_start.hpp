// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// Whether a participant's transports may send.
using SendGate = std::shared_ptr<std::atomic<bool>>;

/// Puts each transport but shared memory behind one that sends nothing until the gate is opened.
///
/// DDS announces a participant a moment before it begins to hear: who answers at once is not heard, and
/// takes the newcomer for one that knows it already.
/// @return the gate, closed; to be opened when the participant is enabled
[[nodiscard]] SendGate hold_back_network(dds::DomainParticipantQos& qos);

}  // namespace caravan::runtime
