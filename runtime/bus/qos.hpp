// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <memory>
#include <string>

#include "idl/topics.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/fastdds_version.hpp"

/// How the lockstep load is tuned for Fast DDS 2.9; docs/decisions/0003-fast-dds-recipe.md has the
/// measurements.
namespace caravan::runtime {

/// The transport of a run on one machine: nothing leaves it.
[[nodiscard]] std::shared_ptr<rtps::TransportDescriptorInterface> shared_memory();
/// UDP over 127.0.0.1 alone. Peers are found by unicast; no multicast is sent.
[[nodiscard]] std::shared_ptr<rtps::TransportDescriptorInterface> loopback_udp();
[[nodiscard]] dds::DomainParticipantQos participant_qos(const std::string& name, const BusConfig& config);
[[nodiscard]] dds::DataWriterQos writer_qos(idl::Delivery delivery);
[[nodiscard]] dds::DataReaderQos reader_qos(idl::Delivery delivery);

}  // namespace caravan::runtime
