// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/reach.hpp"

#include "runtime/bus/bus.hpp"
#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/profile.hpp"
#include "runtime/bus/qos.hpp"

namespace caravan::runtime {

Reach reach_of(const Transport& transport) {
  const auto qos = participant_qos("", {.role = "", .domain = 0, .transport = transport});
  Reach reach;
  reach.shared_memory = uses_shared_memory(qos);
  reach.network = qos.transport().use_builtin_transports;
  for (const auto& one : qos.transport().user_transports) {
    const auto* udp = dynamic_cast<const rtps::UDPTransportDescriptor*>(one.get());
    if (udp == nullptr) continue;
    reach.network = true;
    reach.interfaces.insert(reach.interfaces.end(), udp->interfaceWhiteList.begin(),
                            udp->interfaceWhiteList.end());
  }
  for (const rtps::Locator_t& locator : server_locators(qos.wire_protocol().builtin)) {
    reach.servers.push_back(
        {rtps::IPLocator::toIPv4string(locator), rtps::IPLocator::getPhysicalPort(locator)});
  }
  return reach;
}

std::string dds_version() { return kDdsVersion; }

std::string dds_library() { return kDdsLibrary; }

}  // namespace caravan::runtime
