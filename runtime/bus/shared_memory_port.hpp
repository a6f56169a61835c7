// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/Locator.h>

#include <cstdint>

namespace caravan::runtime {

/// A number of a shared-memory port of the domain that nobody has had before.
///
/// Processes that have sent to a killed one keep its port mapped and go on sending into it: whoever got the
/// same number would never be heard from by them.
[[nodiscard]] std::uint32_t fresh_port(std::uint32_t domain);

/// Where a port with one reader is. @param own  of a participant: its host is part of the address
[[nodiscard]] eprosima::fastrtps::rtps::Locator_t shared_memory_locator(
    std::uint32_t port, const eprosima::fastrtps::rtps::GUID_t& own);

/// Whether a port of shared memory (/dev/shm/fastrtps_portNUMBER) is of the domain: one of those above, or of
/// the 250 that DDS itself gives a domain.
[[nodiscard]] bool is_port_of(std::uint32_t port, std::uint32_t domain);

}  // namespace caravan::runtime
