// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <memory>
#include <string>

#include "idl/topics.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/fastdds_version.hpp"

/// QoS and transport settings, tuned for the lockstep; docs/decisions/0003-fast-dds-recipe.md has the
/// measurements.
namespace caravan::runtime {

/// The transport of a run on one machine: nothing leaves the machine.
[[nodiscard]] std::shared_ptr<rtps::TransportDescriptorInterface> shared_memory();
/// UDP over 127.0.0.1 only. Peers are found by unicast; no multicast is sent.
[[nodiscard]] std::shared_ptr<rtps::TransportDescriptorInterface> loopback_udp();
[[nodiscard]] dds::DomainParticipantQos participant_qos(const std::string& name, const BusConfig& config);
[[nodiscard]] dds::DataWriterQos writer_qos(idl::Delivery delivery);
[[nodiscard]] dds::DataReaderQos reader_qos(idl::Delivery delivery);

}  // namespace caravan::runtime
