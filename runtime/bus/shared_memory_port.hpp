// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// A number of a shared-memory port of the domain that nobody has had before.
///
/// Processes that have sent to a killed one keep its port mapped and go on sending into it: whoever got the
/// same number would never be heard from by them.
[[nodiscard]] std::uint32_t fresh_port(std::uint32_t domain);

/// Where a port with one reader is. @param own  of a participant: its host is part of the address
[[nodiscard]] rtps::Locator_t shared_memory_locator(std::uint32_t port, const rtps::GUID_t& own);

/// What the names of DDS's files in /dev/shm begin with; those of semaphores have "sem." before it.
[[nodiscard]] std::string shared_memory_mark();
/// The file of a port, whether there is one or not.
[[nodiscard]] std::filesystem::path port_file(std::uint32_t port);

/// Whether a port of shared memory is of the domain: one of those above, or of
/// the 250 that DDS itself gives a domain.
[[nodiscard]] bool is_port_of(std::uint32_t port, std::uint32_t domain);

}  // namespace caravan::runtime
