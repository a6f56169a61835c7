// SPDX-License-Identifier: Apache-2.0
/// What differs between Fast DDS 3.1 (Debian 13) and 2.9 (Debian 12), twice under the same names, those
/// of 3.1 where it has one. No other file asks which of the two it is built with.
#pragma once

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <string>

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
#include <vector>

namespace caravan::runtime {
namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

inline constexpr const char* kDdsVersion = FASTDDS_VERSION_STR;
inline constexpr const char* kDdsLibrary = "libfastdds";
/// The names of its files in /dev/shm begin with it.
inline constexpr const char* kSharedMemoryMark = "fastdds_";
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

/// What DDS finds of other participants; called on its threads.
class DiscoveryEvents : public dds::DomainParticipantListener {
 protected:
  virtual void participant_found(const rtps::GUID_t& guid, const std::string& name) = 0;
  virtual void participant_gone(const rtps::GUID_t& guid) = 0;
  virtual void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                            const std::string& topic) = 0;
  virtual void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                            const std::string& topic) = 0;

 private:
  void on_participant_discovery(dds::DomainParticipant* /*own*/, rtps::ParticipantDiscoveryStatus status,
                                const rtps::ParticipantBuiltinTopicData& info, bool& /*ignored*/) final {
    using Status = rtps::ParticipantDiscoveryStatus;
    if (status == Status::DISCOVERED_PARTICIPANT)
      participant_found(info.guid, info.participant_name.to_string());
    if (status == Status::REMOVED_PARTICIPANT || status == Status::DROPPED_PARTICIPANT)
      participant_gone(info.guid);
  }
  void on_data_writer_discovery(dds::DomainParticipant* own, rtps::WriterDiscoveryStatus status,
                                const rtps::PublicationBuiltinTopicData& info, bool& /*ignored*/) final {
    if (status == rtps::WriterDiscoveryStatus::DISCOVERED_WRITER)
      writer_found(own, info.guid, info.topic_name.to_string());
  }
  void on_data_reader_discovery(dds::DomainParticipant* own, rtps::ReaderDiscoveryStatus status,
                                const rtps::SubscriptionBuiltinTopicData& info, bool& /*ignored*/) final {
    if (status == rtps::ReaderDiscoveryStatus::DISCOVERED_READER)
      reader_found(own, info.guid, info.topic_name.to_string());
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

/// What DDS finds of other participants; called on its threads.
class DiscoveryEvents : public dds::DomainParticipantListener {
 protected:
  virtual void participant_found(const rtps::GUID_t& guid, const std::string& name) = 0;
  virtual void participant_gone(const rtps::GUID_t& guid) = 0;
  virtual void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                            const std::string& topic) = 0;
  virtual void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                            const std::string& topic) = 0;

 private:
  void on_participant_discovery(dds::DomainParticipant* /*own*/,
                                rtps::ParticipantDiscoveryInfo&& found) final {
    using Info = rtps::ParticipantDiscoveryInfo;
    if (found.status == Info::DISCOVERED_PARTICIPANT)
      participant_found(found.info.m_guid, found.info.m_participantName.to_string());
    if (found.status == Info::REMOVED_PARTICIPANT || found.status == Info::DROPPED_PARTICIPANT)
      participant_gone(found.info.m_guid);
  }
  void on_publisher_discovery(dds::DomainParticipant* own, rtps::WriterDiscoveryInfo&& found) final {
    if (found.status == rtps::WriterDiscoveryInfo::DISCOVERED_WRITER)
      writer_found(own, found.info.guid(), found.info.topicName().to_string());
  }
  void on_subscriber_discovery(dds::DomainParticipant* own, rtps::ReaderDiscoveryInfo&& found) final {
    if (found.status == rtps::ReaderDiscoveryInfo::DISCOVERED_READER)
      reader_found(own, found.info.guid(), found.info.topicName().to_string());
  }
};

}  // namespace caravan::runtime

#endif
