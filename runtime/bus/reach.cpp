// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/reach.hpp"

#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPTransportDescriptor.h>
#include <fastrtps/config.h>
#include <fastrtps/utils/IPLocator.h>

#include "runtime/bus/bus.hpp"
#include "runtime/bus/profile.hpp"
#include "runtime/bus/qos.hpp"

namespace caravan::runtime {
namespace rtps = eprosima::fastrtps::rtps;

Reach reach_of(const Transport& transport) {
  const auto qos = participant_qos("", {.role = "", .domain = 0, .transport = transport});
  Reach reach;
  reach.shared_memory = uses_shared_memory(qos);
  reach.network = qos.transport().use_builtin_transports;
  for (const auto& one : qos.transport().user_transports) {
    const auto* udp = dynamic_cast<const eprosima::fastdds::rtps::UDPTransportDescriptor*>(one.get());
    if (udp == nullptr) continue;
    reach.network = true;
    reach.interfaces.insert(reach.interfaces.end(), udp->interfaceWhiteList.begin(),
                            udp->interfaceWhiteList.end());
  }
  for (const auto& server : qos.wire_protocol().builtin.discovery_config.m_DiscoveryServers) {
    for (const rtps::Locator_t& locator : server.metatrafficUnicastLocatorList) {
      reach.servers.push_back(
          {rtps::IPLocator::toIPv4string(locator), rtps::IPLocator::getPhysicalPort(locator)});
    }
  }
  return reach;
}

std::string dds_version() { return FASTRTPS_VERSION_STR; }

}  // namespace caravan::runtime
