// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <string>

#include "idl/topics.hpp"

/// How the lockstep load is tuned for Fast DDS 2.9; docs/decisions/0003-fast-dds-recipe.md has the
/// measurements.
namespace caravan::runtime {

[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos participant_qos(const std::string& name,
                                                                           double lease_s);
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writer_qos(idl::Delivery delivery);
[[nodiscard]] eprosima::fastdds::dds::DataReaderQos reader_qos(idl::Delivery delivery);

}  // namespace caravan::runtime
