// SPDX-License-Identifier: Apache-2.0
/// Fast DDS 3.1; included only by fastdds_version.hpp.
#pragma once

#include <cstdint>
#include <fastdds/LibrarySettings.hpp>
#include <fastdds/config.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.hpp>
#include <fastdds/rtps/attributes/WriterAttributes.hpp>
#include <fastdds/rtps/common/Guid.hpp>
#include <fastdds/rtps/common/Locator.hpp>
#include <fastdds/rtps/common/SerializedPayload.hpp>
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.hpp>
#include <fastdds/utils/IPLocator.hpp>
#include <memory>
#include <string>
#include <vector>

#include "runtime/bus/fastdds_common.hpp"
#include "runtime/bus/whole_messages.hpp"

namespace caravan::runtime {
namespace rtps = eprosima::fastdds::rtps;

inline constexpr const char* kDdsVersion = FASTDDS_VERSION_STR;
inline constexpr const char* kDdsLibrary = "libfastdds";
/// Prefix of its files in /dev/shm.
inline constexpr const char* kSharedMemoryMark = "fastdds_";
/// Whether it stops reading a port at a message whose segment is gone.
inline constexpr bool kStopsAtLostSegments = false;
/// The profile in deploy/fastdds that uses a Discovery Server.
inline constexpr const char* kDiscoveryProfile = "discovery_3.xml";

using Duration = dds::Duration_t;

using Payload = rtps::SerializedPayload_t;

inline bool is_ok(dds::ReturnCode_t code) { return code == dds::RETCODE_OK; }
inline Duration& heartbeat_period(rtps::WriterTimes& times) { return times.heartbeat_period; }
inline Duration& nack_suppression(rtps::WriterTimes& times) { return times.nack_supression_duration; }
inline const rtps::LocatorList& server_locators(const rtps::BuiltinAttributes& discovery) {
  return discovery.discovery_config.m_DiscoveryServers;
}

/// Call before the first participant is created.
inline void turn_intraprocess_delivery_off() {
  eprosima::fastdds::LibrarySettings settings;
  settings.intraprocess_delivery = eprosima::fastdds::INTRAPROCESS_OFF;
  dds::DomainParticipantFactory::get_instance()->set_library_settings(settings);
}

/// @pre `transport` is shared memory
inline std::shared_ptr<rtps::TransportDescriptorInterface> with_whole_messages(
    const std::shared_ptr<rtps::TransportDescriptorInterface>& transport) {
  return std::make_shared<WholeMessagesDescriptor>(
      dynamic_cast<const rtps::SharedMemTransportDescriptor&>(*transport));
}

/// QoS of a writer or a reader, from its discovery data.
template <typename Data>
EndpointQos endpoint_qos(const Data& data) {
  EndpointQos qos;
  qos.type = data.type_name.to_string();
  qos.reliable = data.reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  qos.durability = static_cast<EndpointQos::Durability>(data.durability.kind);
  qos.xcdr1 = has_xcdr1(data.representation);
  qos.exclusive = data.ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  qos.in_partition = is_in_partition(data.partition);
  return qos;
}

/// Generated type support whose virtual functions have the same signature in all versions.
template <typename PubSubType>
class PortableType : public PubSubType {
 public:
  virtual bool write(const void* sample, Payload& to) {
    return PubSubType::serialize(sample, to, dds::XCDR_DATA_REPRESENTATION);
  }
  virtual bool read(Payload& from, void* sample) {
    // Fast CDR 2 accepts a sample that ends between two members as complete.
    return PubSubType::deserialize(from, sample) && size_of(sample) <= from.length;
  }
  virtual std::uint32_t size_of(const void* sample) {
    return PubSubType::calculate_serialized_size(sample, dds::XCDR_DATA_REPRESENTATION);
  }

 private:
  bool serialize(const void* const sample, Payload& to, dds::DataRepresentationId_t /*which*/) final {
    return write(sample, to);
  }
  bool deserialize(Payload& from, void* sample) final { return read(from, sample); }
  std::uint32_t calculate_serialized_size(const void* const sample,
                                          dds::DataRepresentationId_t /*which*/) final {
    return size_of(sample);
  }
};

class DiscoveryEvents : public DiscoveryEventsOf<rtps::GUID_t> {
  void on_participant_discovery(dds::DomainParticipant* /*own*/, rtps::ParticipantDiscoveryStatus status,
                                const rtps::ParticipantBuiltinTopicData& info, bool& /*ignored*/) final {
    using Status = rtps::ParticipantDiscoveryStatus;
    if (status == Status::DISCOVERED_PARTICIPANT)
      participant_found(info.guid, info.participant_name.to_string(), properties_of(info.properties));
    if (status == Status::REMOVED_PARTICIPANT || status == Status::DROPPED_PARTICIPANT)
      participant_gone(info.guid);
  }
  void on_data_writer_discovery(dds::DomainParticipant* own, rtps::WriterDiscoveryStatus status,
                                const rtps::PublicationBuiltinTopicData& info, bool& /*ignored*/) final {
    if (status == rtps::WriterDiscoveryStatus::DISCOVERED_WRITER)
      writer_found(own, info.guid, info.topic_name.to_string(), endpoint_qos(info));
    if (status == rtps::WriterDiscoveryStatus::REMOVED_WRITER)
      writer_gone(own, info.guid, info.topic_name.to_string());
  }
  void on_data_reader_discovery(dds::DomainParticipant* own, rtps::ReaderDiscoveryStatus status,
                                const rtps::SubscriptionBuiltinTopicData& info, bool& /*ignored*/) final {
    if (status == rtps::ReaderDiscoveryStatus::DISCOVERED_READER)
      reader_found(own, info.guid, info.topic_name.to_string(), endpoint_qos(info));
  }
};

}  // namespace caravan::runtime
