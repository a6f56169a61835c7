// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/place.hpp"

#include <unistd.h>

#include <charconv>
#include <string>
#include <vector>

#include "runtime/bus/local_names.hpp"
#include "runtime/bus/shared_memory_port.hpp"

namespace caravan::runtime {
namespace {

/// Prefix of the names of a domain's places; the port's number follows.
std::string mark_of(std::uint32_t domain) { return "caravan/" + std::to_string(domain) + "/"; }

}  // namespace

std::vector<std::uint32_t> places_in(std::uint32_t domain) {
  std::vector<std::uint32_t> ports;
  for (const std::string& digits : local_names(mark_of(domain))) {
    std::uint32_t port = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), port).ec == std::errc{})
      ports.push_back(port);
  }
  return ports;
}

Place::Place(std::uint32_t domain) : domain_{domain} {
  while (held_ < 0) {
    port_ = fresh_port(domain);
    held_ = hold_local_name(mark_of(domain) + std::to_string(port_));
  }
}

Place::~Place() { close(held_); }

void Place::settle(rtps::BuiltinAttributes& discovery, const rtps::GUID_t& own) const {
  discovery.metatrafficUnicastLocatorList.clear();
  discovery.metatrafficUnicastLocatorList.push_back(shared_memory_locator(port_, own));
  discovery.initialPeersList.clear();
  for (const std::uint32_t other : places_in(domain_)) {
    if (other != port_) discovery.initialPeersList.push_back(shared_memory_locator(other, own));
  }
}

}  // namespace caravan::runtime
