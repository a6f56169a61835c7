// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <filesystem>
#include <memory>

namespace caravan::runtime {

/// Name of the participant profile that a file for `--transport` has to have.
inline constexpr const char* kProfileName = "caravan";

/// The participant profile of a Fast DDS XML file.
///
/// DDS keeps what it has read for the life of the process: only one file may be used in one process.
/// @throws StartError when it cannot be read or has no such profile; DDS has said on standard error why
[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos read_profile(const std::filesystem::path& file);

[[nodiscard]] bool is_shared_memory(
    const std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface>& transport);
/// Whether one of its transports is shared memory.
[[nodiscard]] bool uses_shared_memory(const eprosima::fastdds::dds::DomainParticipantQos& qos);
[[nodiscard]] bool uses_shared_memory_alone(const eprosima::fastdds::dds::DomainParticipantQos& qos);

}  // namespace caravan::runtime
