// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// A number of a shared-memory port of the domain that no process used before.
///
/// Processes that have sent to a killed one keep its port mapped and continue to send into it: they would
/// never receive from a new owner of the same number.
[[nodiscard]] std::uint32_t fresh_port(std::uint32_t domain);

/// Address of a port with one reader. @param own  GUID of the participant: its host is part of the address
[[nodiscard]] rtps::Locator_t shared_memory_locator(std::uint32_t port, const rtps::GUID_t& own);

/// Prefix of DDS's files in /dev/shm; the names of semaphores have "sem." before it.
[[nodiscard]] std::string shared_memory_mark();
/// Path of a port's file, whether it exists or not.
[[nodiscard]] std::filesystem::path port_file(std::uint32_t port);

/// Whether a port of shared memory belongs to the domain: one from fresh_port(), or one of the 250 that DDS
/// itself assigns to a domain.
[[nodiscard]] bool is_port_of(std::uint32_t port, std::uint32_t domain);

}  // namespace caravan::runtime
