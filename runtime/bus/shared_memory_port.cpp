// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/shared_memory_port.hpp"

#include <random>

namespace caravan::runtime {
namespace {

constexpr std::uint32_t kPortsOfADomain = 1'000'000;  // those of domain 0 start here

}  // namespace

std::uint32_t fresh_port(std::uint32_t domain) {
  // Random, because two processes that start at the same moment see the same files.
  std::random_device source;
  std::uniform_int_distribution<std::uint32_t> number{0, kPortsOfADomain - 1};
  std::error_code error;
  std::uint32_t port = 0;
  do {
    port = kPortsOfADomain * (domain + 1) + number(source);
  } while (std::filesystem::exists(port_file(port), error));
  return port;
}

rtps::Locator_t shared_memory_locator(std::uint32_t port, const rtps::GUID_t& own) {
  rtps::Locator_t locator{LOCATOR_KIND_SHM, port};
  locator.address[0] = 'U';  // one reader
  locator.address[1] = own.guidPrefix.value[2];
  locator.address[2] = own.guidPrefix.value[3];
  return locator;
}

std::string shared_memory_mark() { return kSharedMemoryMark; }

std::filesystem::path port_file(std::uint32_t port) {
  return std::filesystem::path{"/dev/shm"} / (shared_memory_mark() + "port" + std::to_string(port));
}

bool is_port_of(std::uint32_t port, std::uint32_t domain) {
  constexpr std::uint32_t kFirst = 7400;
  constexpr std::uint32_t kPorts = 250;
  return port / kPortsOfADomain == domain + 1 ||
         (port >= kFirst + kPorts * domain && port < kFirst + kPorts * (domain + 1));
}

}  // namespace caravan::runtime
