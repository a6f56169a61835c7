// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/place.hpp"

#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastrtps/utils/IPLocator.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace rtps = eprosima::fastrtps::rtps;
namespace {

/// Where the process of this place listens for newcomers; DDS's own rule.
std::uint16_t discovery_port(std::uint32_t domain, std::uint32_t number) {
  return static_cast<std::uint16_t>(7410 + 250 * domain + 2 * number);
}

/// DDS over UDP receives samples here; over shared memory nobody does.
std::uint16_t holding_port(std::uint32_t domain, std::uint32_t number) {
  return static_cast<std::uint16_t>(discovery_port(domain, number) + 1);
}

/// A socket that has this port of 127.0.0.1, -1 when somebody else has it.
int hold(std::uint16_t port) {
  const int held = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  if (bind(held, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return held;
  close(held);
  return -1;
}

bool is_taken(std::uint16_t port) {
  const int held = hold(port);
  if (held >= 0) close(held);
  return held < 0;
}

rtps::Locator_t loopback(std::uint16_t port) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = port;
  rtps::IPLocator::setIPv4(locator, "127.0.0.1");
  return locator;
}

}  // namespace

Place::Place(std::uint32_t domain) : domain_{domain} {
  for (; number_ < kMostProcesses; ++number_) {
    held_ = hold(holding_port(domain_, number_));
    if (held_ < 0) continue;
    if (!is_taken(discovery_port(domain_, number_))) return;
    close(held_);  // somebody is there who holds no places
  }
  throw StartError{"domain " + std::to_string(domain_) + " has " + std::to_string(kMostProcesses) +
                   " processes on this machine already, or UDP on 127.0.0.1 is not possible"};
}

Place::~Place() { close(held_); }

void Place::settle(rtps::BuiltinAttributes& discovery) const {
  discovery.metatrafficUnicastLocatorList.clear();
  discovery.metatrafficUnicastLocatorList.push_back(loopback(discovery_port(domain_, number_)));
  discovery.initialPeersList.clear();
  for (std::uint32_t other = 0; other < kMostProcesses; ++other) {
    if (other < number_ || (other > number_ && is_taken(holding_port(domain_, other))))
      discovery.initialPeersList.push_back(loopback(discovery_port(domain_, other)));
  }
}

}  // namespace caravan::runtime
