// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// Name of the participant profile that a file for `--transport` must contain.
inline constexpr const char* kProfileName = "caravan";

/// The participant profile of a Fast DDS XML file.
///
/// DDS keeps what it has read until the process ends: a process may use only one file.
/// @throws StartError when it cannot be read or has no such profile; DDS prints the reason to standard error
[[nodiscard]] dds::DomainParticipantQos read_profile(const std::filesystem::path& file);

[[nodiscard]] bool is_shared_memory(const std::shared_ptr<rtps::TransportDescriptorInterface>& transport);
/// Whether one of its transports is shared memory.
[[nodiscard]] bool uses_shared_memory(const dds::DomainParticipantQos& qos);
[[nodiscard]] bool uses_shared_memory_alone(const dds::DomainParticipantQos& qos);

}  // namespace caravan::runtime
