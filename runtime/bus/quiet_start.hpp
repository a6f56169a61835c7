// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// Whether a participant's transports may send.
using SendGate = std::shared_ptr<std::atomic<bool>>;

/// Wraps each transport except shared memory in one that sends nothing until the gate is opened.
///
/// DDS announces a participant a moment before it can receive. The answer of a fast peer is then lost, and
/// the peer believes that the new participant already knows it.
/// @return the gate, closed; open it when the participant is enabled
[[nodiscard]] SendGate hold_back_network(dds::DomainParticipantQos& qos);

}  // namespace caravan::runtime
