// SPDX-License-Identifier: Apache-2.0
/// Fast DDS 2.9; included only by fastdds_version.hpp.
#pragma once

#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/attributes/WriterAttributes.h>
#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/common/SerializedPayload.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/config.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <cstdint>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <functional>
#include <memory>
#include <string>

#include "runtime/bus/fastdds_common.hpp"

namespace caravan::runtime {
/// 2.9 has its transports in one namespace and everything else in the other.
namespace rtps {
using namespace eprosima::fastdds::rtps;   // NOLINT(google-build-using-namespace)
using namespace eprosima::fastrtps::rtps;  // NOLINT(google-build-using-namespace)
// The other namespace has aliases of these, which clang does not treat as the same types.
using eprosima::fastdds::rtps::LocatorsIterator;
using eprosima::fastdds::rtps::TransportDescriptorInterface;
using eprosima::fastdds::rtps::TransportInterface;
using eprosima::fastdds::rtps::TransportReceiverInterface;
using eprosima::fastdds::rtps::UDPTransportDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
}  // namespace rtps

inline constexpr const char* kDdsVersion = FASTRTPS_VERSION_STR;
inline constexpr const char* kDdsLibrary = "libfastrtps";
/// Prefix of its files in /dev/shm.
inline constexpr const char* kSharedMemoryMark = "fastrtps_";
/// Whether it stops reading a port at a message whose segment is gone.
inline constexpr bool kStopsAtLostSegments = true;
/// The profile in deploy/fastdds that uses a Discovery Server.
inline constexpr const char* kDiscoveryProfile = "discovery.xml";

using Duration = eprosima::fastrtps::Duration_t;
/// The bytes that a transport is to send.
using OutgoingBytes = const rtps::octet*;

using Payload = rtps::SerializedPayload_t;

inline bool is_ok(const ReturnCode_t& code) { return code == ReturnCode_t::RETCODE_OK; }
inline bool is_ok(bool written) { return written; }
inline Duration& heartbeat_period(rtps::WriterTimes& times) { return times.heartbeatPeriod; }
inline Duration& nack_suppression(rtps::WriterTimes& times) { return times.nackSupressionDuration; }
inline rtps::LocatorList server_locators(const rtps::BuiltinAttributes& discovery) {
  rtps::LocatorList all;
  for (const auto& server : discovery.discovery_config.m_DiscoveryServers) {
    for (const auto& locator : server.metatrafficUnicastLocatorList) all.push_back(locator);
  }
  return all;
}

/// Call before the first participant is created.
inline void turn_intraprocess_delivery_off() {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

/// Nothing to do: 2.9 sends messages whole.
inline std::shared_ptr<rtps::TransportDescriptorInterface> with_whole_messages(
    const std::shared_ptr<rtps::TransportDescriptorInterface>& transport) {
  return transport;
}

/// QoS of a writer or a reader, from its discovery data.
template <typename Data>
EndpointQos endpoint_qos(const Data& data) {
  EndpointQos qos;
  qos.type = data.typeName().to_string();
  qos.reliable = data.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  qos.durability = static_cast<EndpointQos::Durability>(data.m_qos.m_durability.kind);
  qos.xcdr1 = has_xcdr1(data.m_qos.representation);
  qos.exclusive = data.m_qos.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  qos.in_partition = is_in_partition(data.m_qos.m_partition);
  return qos;
}

/// Generated type support whose virtual functions have the same signature in all versions.
template <typename PubSubType>
class PortableType : public PubSubType {
 public:
  virtual bool write(const void* sample, Payload& to) {
    return PubSubType::serialize(const_cast<void*>(sample), &to);
  }
  virtual bool read(Payload& from, void* sample) { return PubSubType::deserialize(&from, sample); }
  virtual std::uint32_t size_of(const void* sample) {
    return PubSubType::getSerializedSizeProvider(const_cast<void*>(sample))();
  }

 private:
  bool serialize(void* sample, Payload* to) final { return write(sample, *to); }
  bool deserialize(Payload* from, void* sample) final { return read(*from, sample); }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* sample) final {
    return [this, sample] { return size_of(sample); };
  }
};

class DiscoveryEvents : public DiscoveryEventsOf<rtps::GUID_t> {
  void on_participant_discovery(dds::DomainParticipant* /*own*/,
                                rtps::ParticipantDiscoveryInfo&& found) final {
    using Info = rtps::ParticipantDiscoveryInfo;
    if (found.status == Info::DISCOVERED_PARTICIPANT)
      participant_found(found.info.m_guid, found.info.m_participantName.to_string(),
                        properties_of(found.info.m_properties));
    if (found.status == Info::REMOVED_PARTICIPANT || found.status == Info::DROPPED_PARTICIPANT)
      participant_gone(found.info.m_guid);
  }
  void on_publisher_discovery(dds::DomainParticipant* own, rtps::WriterDiscoveryInfo&& found) final {
    const std::string topic = found.info.topicName().to_string();
    if (found.status == rtps::WriterDiscoveryInfo::DISCOVERED_WRITER)
      writer_found(own, found.info.guid(), topic, endpoint_qos(found.info));
    if (found.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) writer_gone(own, found.info.guid(), topic);
  }
  void on_subscriber_discovery(dds::DomainParticipant* own, rtps::ReaderDiscoveryInfo&& found) final {
    if (found.status == rtps::ReaderDiscoveryInfo::DISCOVERED_READER)
      reader_found(own, found.info.guid(), found.info.topicName().to_string(), endpoint_qos(found.info));
  }
};

}  // namespace caravan::runtime
