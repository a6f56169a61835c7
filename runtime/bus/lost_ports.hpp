// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// Has the shared-memory transports take what they cannot deliver for delivered.
///
/// A process that leaves removes its port. One that was suspended meanwhile, or that starts in that moment,
/// goes on sending to it: its announcements, for as long as it takes the other for living, or for good when
/// that is one of the peers that it began with. Fast DDS 2.9 tries an announcement that was not sent again at
/// once, some thousand times a second. What is lost so is repaired as anything that a full port loses.
void tolerate_lost_ports(dds::DomainParticipantQos& qos);

}  // namespace caravan::runtime
