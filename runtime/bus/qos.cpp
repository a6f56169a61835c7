// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/qos.hpp"

#include <filesystem>
#include <limits>
#include <memory>

#include "runtime/bus/profile.hpp"
#include "runtime/bus/shared_memory_port.hpp"

namespace caravan::runtime {
namespace {

constexpr std::uint32_t kMostProcesses = 120;  // in a domain on UDP: each uses two of its 250 ports
// Fraction of the lease. Every process announces itself to every other, which is most of the cost of waiting;
// any other message of a process renews its lease too.
constexpr double kAnnouncedAfter = 0.4;

constexpr std::int32_t depth_of(idl::Delivery delivery) {
  switch (delivery) {
    case idl::Delivery::kStep:
    case idl::Delivery::kHealth:
      return 4;
    case idl::Delivery::kRequest:
      return 64;
    case idl::Delivery::kObserved:
      return 2 * static_cast<std::int32_t>(idl::kMaxStepsAhead);
    case idl::Delivery::kLatest:
      return 1;
  }
  return 1;
}

/// The settings that writers and readers share.
template <typename Qos>
void set_common(Qos& qos, idl::Delivery delivery) {
  const bool latest = delivery == idl::Delivery::kLatest;
  qos.reliability().kind = latest ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
  const bool fleeting = latest || delivery == idl::Delivery::kRequest;
  qos.durability().kind = fleeting ? dds::VOLATILE_DURABILITY_QOS : dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth_of(delivery);
  qos.resource_limits().max_samples = depth_of(delivery);
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = depth_of(delivery);
  qos.resource_limits().allocated_samples = delivery == idl::Delivery::kObserved ? 0 : depth_of(delivery);
  qos.endpoint().history_memory_policy = delivery == idl::Delivery::kObserved
                                             ? rtps::DYNAMIC_REUSABLE_MEMORY_MODE
                                             : rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();  // slower here, and more threads
}

/// The lowest participant number of the domain whose ports no process has used yet, -1 when there is none.
///
/// DDS itself would take the lowest number not in use. But processes that have sent to a killed one keep its
/// ports mapped and continue to send into them: they would never receive from a new owner of the same
/// numbers.
std::int32_t fresh_number(std::uint32_t domain) {
  constexpr std::uint32_t kFirstPort = 7410;
  constexpr std::uint32_t kPortsOfADomain = 250;
  const auto is_used = [](std::uint32_t port) {
    std::error_code error;
    return std::filesystem::exists(port_file(port), error);
  };
  for (std::int32_t number = 0; number < static_cast<std::int32_t>(kMostProcesses); ++number) {
    const std::uint32_t port = kFirstPort + kPortsOfADomain * domain + 2 * static_cast<std::uint32_t>(number);
    if (!is_used(port) && !is_used(port + 1)) return number;
  }
  return -1;
}

/// By unicast to the first participants of this machine; an explicit list keeps DDS from using multicast.
void look_for_peers_on_loopback(rtps::BuiltinAttributes& builtin) {
  rtps::Locator_t loopback;
  loopback.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(loopback, "127.0.0.1");
  builtin.metatrafficUnicastLocatorList.push_back(loopback);
  builtin.initialPeersList.push_back(loopback);
  builtin.mutation_tries = kMostProcesses;  // number of ports tried for a free one
}

/// The settings for reaching others: transports, addresses, ports, discovery.
dds::DomainParticipantQos qos_to_reach_others(const BusConfig& config) {
  if (config.transport.kind == Transport::kProfile) return read_profile(config.transport.profile);
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.transport().use_builtin_transports = false;
  if (config.transport.kind == Transport::kSharedMemory) {
    qos.transport().user_transports.push_back(shared_memory());
    return qos;
  }
  qos.transport().user_transports.push_back(config.around_udp ? config.around_udp : loopback_udp());
  look_for_peers_on_loopback(qos.wire_protocol().builtin);
  return qos;
}

Duration milliseconds(std::uint32_t count) {
  return {static_cast<std::int32_t>(count / 1000), count % 1000 * 1'000'000};
}

}  // namespace

std::shared_ptr<rtps::TransportDescriptorInterface> shared_memory() {
  const auto transport = std::make_shared<rtps::SharedMemTransportDescriptor>();
  // Never (49 days). With the default of 1 s samples are lost for good when a process is stopped for 2 s, and
  // a process that starts between a check and the next message to a checked port hangs.
  transport->healthy_check_timeout_ms(std::numeric_limits<std::uint32_t>::max());
  return transport;
}

std::shared_ptr<rtps::TransportDescriptorInterface> loopback_udp() {
  auto transport = std::make_shared<rtps::UDPv4TransportDescriptor>();
  transport->interfaceWhiteList.emplace_back("127.0.0.1");
  transport->maxInitialPeersRange = kMostProcesses;  // by default the fifth process would not be found
  return transport;
}

dds::DomainParticipantQos participant_qos(const std::string& name, const BusConfig& config) {
  dds::DomainParticipantQos qos = qos_to_reach_others(config);
  qos.name(name.c_str());
  const bool numbers_its_ports = uses_shared_memory(qos) && !uses_shared_memory_alone(qos);
  if (numbers_its_ports && qos.wire_protocol().participant_id < 0) {
    qos.wire_protocol().participant_id = fresh_number(config.domain);
  }
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration = Duration{static_cast<long double>(config.lease_s)};
  discovery.leaseDuration_announcementperiod =
      Duration{static_cast<long double>(config.lease_s * kAnnouncedAfter)};
  return qos;
}

dds::DataWriterQos writer_qos(idl::Delivery delivery) {
  dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
  set_common(qos, delivery);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  auto& reliable = qos.reliable_writer_qos();
  reliable.disable_heartbeat_piggyback = true;
  nack_suppression(reliable.times) = milliseconds(100);  // the default wakes a second thread on every write
  heartbeat_period(reliable.times) = milliseconds(200);  // the delay until a lost sample is noticed
  return qos;
}

dds::DataReaderQos reader_qos(idl::Delivery delivery) {
  dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
  set_common(qos, delivery);
  // Room for newer samples while older ones wait for a gap to be closed. Without it a reader that joins a
  // fast writer late keeps the first few it got, has no room for the newest, and receives nothing for
  // seconds.
  qos.resource_limits().max_samples = 2 * depth_of(delivery);
  qos.resource_limits().max_samples_per_instance = 2 * depth_of(delivery);
  return qos;
}

}  // namespace caravan::runtime
