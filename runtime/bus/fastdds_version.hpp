// SPDX-License-Identifier: Apache-2.0
/// What differs between Fast DDS 3.1 (Debian 13) and 2.9 (Debian 12), twice under the same names, those
/// of 3.1 where it has one. No other file asks which of the two it is built with.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/bus/compatibility.hpp"

#if __has_include(<fastdds/config.hpp>)  // 3.1

#include <fastdds/LibrarySettings.hpp>
#include <fastdds/config.hpp>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.hpp>
#include <fastdds/rtps/attributes/WriterAttributes.hpp>
#include <fastdds/rtps/common/Guid.hpp>
#include <fastdds/rtps/common/Locator.hpp>
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.hpp>
#include <fastdds/utils/IPLocator.hpp>

namespace caravan::runtime {
namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

inline constexpr const char* kDdsVersion = FASTDDS_VERSION_STR;
inline constexpr const char* kDdsLibrary = "libfastdds";
/// The names of its files in /dev/shm begin with it.
inline constexpr const char* kSharedMemoryMark = "fastdds_";
/// Whether it reads no further at a port where it finds a message whose memory is gone.
inline constexpr bool kStopsAtLostSegments = false;
/// The profile of deploy/fastdds that asks a Discovery Server.
inline constexpr const char* kDiscoveryProfile = "discovery_3.xml";

using Duration = dds::Duration_t;
/// What a transport is given to send.
using OutgoingBytes = const std::vector<rtps::NetworkBuffer>&;

inline bool is_ok(dds::ReturnCode_t code) { return code == dds::RETCODE_OK; }
inline Duration& heartbeat_period(rtps::WriterTimes& times) { return times.heartbeat_period; }
inline Duration& nack_suppression(rtps::WriterTimes& times) { return times.nack_supression_duration; }
inline const rtps::LocatorList& server_locators(const rtps::BuiltinAttributes& discovery) {
  return discovery.discovery_config.m_DiscoveryServers;
}

/// Before the first participant.
inline void turn_intraprocess_delivery_off() {
  eprosima::fastdds::LibrarySettings settings;
  settings.intraprocess_delivery = eprosima::fastdds::INTRAPROCESS_OFF;
  dds::DomainParticipantFactory::get_instance()->set_library_settings(settings);
}

/// Shared memory in front of which the statistics that DDS puts behind each message are taken away.
///
/// 3.1.2 leaves room for them and copies nothing into it (3.1.3 does not): the receiver takes what was there
/// before for more of the message, and often does not count the message as a sign of life.
class WholeMessages final : public rtps::ChainingTransport {
 public:
  explicit WholeMessages(const rtps::SharedMemTransportDescriptor& settings)
      : ChainingTransport(Chain{std::make_shared<rtps::SharedMemTransportDescriptor>(settings)}) {}
  rtps::TransportDescriptorInterface* get_configuration() override {
    return low_level_transport_->get_configuration();
  }
  bool send(rtps::SenderResource* sender, OutgoingBytes bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& timeout) override {
    constexpr std::uint32_t kStatisticsSize = 60;
    constexpr rtps::octet kStatistics = 0x80;
    const rtps::NetworkBuffer& last = bytes.back();
    if (last.size != kStatisticsSize || *static_cast<const rtps::octet*>(last.buffer) != kStatistics)
      return sender->send(bytes, size, begin, end, timeout);
    const std::vector<rtps::NetworkBuffer> message(bytes.begin(), bytes.end() - 1);
    return sender->send(message, size - last.size, begin, end, timeout);
  }
  void receive(rtps::TransportReceiverInterface* next, const rtps::octet* buffer, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  struct Chain final : rtps::ChainingTransportDescriptor {
    using ChainingTransportDescriptor::ChainingTransportDescriptor;
    [[nodiscard]] rtps::TransportInterface* create_transport() const override { return nullptr; }
  };
};

/// Is still shared memory for DDS, which looks at the descriptor's class.
struct WholeMessagesDescriptor final : rtps::SharedMemTransportDescriptor {
  explicit WholeMessagesDescriptor(const rtps::SharedMemTransportDescriptor& settings)
      : rtps::SharedMemTransportDescriptor(settings) {}
  [[nodiscard]] rtps::TransportInterface* create_transport() const override {
    return new WholeMessages(*this);
  }
};

/// @pre it is shared memory
inline std::shared_ptr<rtps::TransportDescriptorInterface> with_whole_messages(
    const std::shared_ptr<rtps::TransportDescriptorInterface>& transport) {
  return std::make_shared<WholeMessagesDescriptor>(
      dynamic_cast<const rtps::SharedMemTransportDescriptor&>(*transport));
}

template <typename Pairs, typename Properties>
Pairs to_pairs(const Properties& properties) {
  Pairs pairs;
  for (const auto& one : properties) pairs.emplace_back(one.first(), one.second());
  return pairs;
}

template <typename Partitions>
bool is_in_partition(const Partitions& partitions) {
  const auto names = partitions.getNames();
  const auto is_default = [](const std::string& name) { return name.empty() || name == "*"; };
  return !names.empty() && std::none_of(names.begin(), names.end(), is_default);
}

template <typename Representation>
bool has_xcdr1(const Representation& representation) {
  const auto& all = representation.m_value;
  return all.empty() || std::find(all.begin(), all.end(), dds::XCDR_DATA_REPRESENTATION) != all.end();
}

/// Of a writer or a reader.
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

/// What DDS finds of other participants; called on its threads.
class DiscoveryEvents : public dds::DomainParticipantListener {
 protected:
  using Properties = std::vector<std::pair<std::string, std::string>>;
  virtual void participant_found(const rtps::GUID_t& guid, const std::string& name,
                                 const Properties& properties) = 0;
  virtual void participant_gone(const rtps::GUID_t& guid) = 0;
  virtual void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;
  virtual void writer_gone(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                           const std::string& topic) = 0;
  virtual void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;

 private:
  void on_participant_discovery(dds::DomainParticipant* /*own*/, rtps::ParticipantDiscoveryStatus status,
                                const rtps::ParticipantBuiltinTopicData& info, bool& /*ignored*/) final {
    using Status = rtps::ParticipantDiscoveryStatus;
    if (status == Status::DISCOVERED_PARTICIPANT)
      participant_found(info.guid, info.participant_name.to_string(), to_pairs<Properties>(info.properties));
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

#else  // 2.9

#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/attributes/WriterAttributes.h>
#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/config.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>

namespace caravan::runtime {
namespace dds = eprosima::fastdds::dds;
/// 2.9 has its transports in one namespace and all else in the other.
namespace rtps {
using namespace eprosima::fastdds::rtps;   // NOLINT(google-build-using-namespace)
using namespace eprosima::fastrtps::rtps;  // NOLINT(google-build-using-namespace)
}  // namespace rtps

inline constexpr const char* kDdsVersion = FASTRTPS_VERSION_STR;
inline constexpr const char* kDdsLibrary = "libfastrtps";
/// The names of its files in /dev/shm begin with it.
inline constexpr const char* kSharedMemoryMark = "fastrtps_";
/// Whether it reads no further at a port where it finds a message whose memory is gone.
inline constexpr bool kStopsAtLostSegments = true;
/// The profile of deploy/fastdds that asks a Discovery Server.
inline constexpr const char* kDiscoveryProfile = "discovery.xml";

using Duration = eprosima::fastrtps::Duration_t;
/// What a transport is given to send.
using OutgoingBytes = const rtps::octet*;

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

/// Before the first participant.
inline void turn_intraprocess_delivery_off() {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

/// For 3.1.
inline std::shared_ptr<rtps::TransportDescriptorInterface> with_whole_messages(
    const std::shared_ptr<rtps::TransportDescriptorInterface>& transport) {
  return transport;
}

template <typename Pairs, typename Properties>
Pairs to_pairs(const Properties& properties) {
  Pairs pairs;
  for (const auto& one : properties) pairs.emplace_back(one.first(), one.second());
  return pairs;
}

template <typename Partitions>
bool is_in_partition(const Partitions& partitions) {
  const auto names = partitions.getNames();
  const auto is_default = [](const std::string& name) { return name.empty() || name == "*"; };
  return !names.empty() && std::none_of(names.begin(), names.end(), is_default);
}

template <typename Representation>
bool has_xcdr1(const Representation& representation) {
  const auto& all = representation.m_value;
  return all.empty() || std::find(all.begin(), all.end(), dds::XCDR_DATA_REPRESENTATION) != all.end();
}

/// Of a writer or a reader.
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

/// What DDS finds of other participants; called on its threads.
class DiscoveryEvents : public dds::DomainParticipantListener {
 protected:
  using Properties = std::vector<std::pair<std::string, std::string>>;
  virtual void participant_found(const rtps::GUID_t& guid, const std::string& name,
                                 const Properties& properties) = 0;
  virtual void participant_gone(const rtps::GUID_t& guid) = 0;
  virtual void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;
  virtual void writer_gone(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                           const std::string& topic) = 0;
  virtual void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;

 private:
  void on_participant_discovery(dds::DomainParticipant* /*own*/,
                                rtps::ParticipantDiscoveryInfo&& found) final {
    using Info = rtps::ParticipantDiscoveryInfo;
    if (found.status == Info::DISCOVERED_PARTICIPANT)
      participant_found(found.info.m_guid, found.info.m_participantName.to_string(),
                        to_pairs<Properties>(found.info.m_properties));
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

#endif
