// SPDX-License-Identifier: Apache-2.0
#include "deploy/doctor/collect.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <sys/timex.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/host/shared_memory.hpp"
#include "runtime/process/data_folder.hpp"

namespace caravan::deploy {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> missing_programs() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<std::string> missing;
  for (const char* name : {"world_server", "radio_emulator", "robot_agent"}) {
    if (access((folder / name).c_str(), X_OK) != 0) missing.emplace_back(name);
  }
  return missing;
}

/// Version from the name of the library file mapped into this process: libfastdds.so.3.1.2.
std::string loaded_dds() {
  const std::string mark = runtime::dds_library() + ".so.";
  std::ifstream maps{"/proc/self/maps"};
  for (std::string line; std::getline(maps, line);) {
    const std::size_t place = line.find(mark);
    if (place != std::string::npos) return line.substr(place + mark.size());
  }
  return "";
}

/// Numbers in a file of /proc; empty when it cannot be read.
std::vector<std::uint64_t> numbers_in(const fs::path& file) {
  std::ifstream stream{file};
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t number = 0; stream >> number;) numbers.push_back(number);
  return numbers;
}

std::uint64_t number_in(const fs::path& file) {
  const auto numbers = numbers_in(file);
  return numbers.empty() ? 0 : numbers.front();
}

std::vector<std::uint16_t> udp_ports() {
  std::vector<std::uint16_t> ports;
  for (const char* table : {"/proc/net/udp", "/proc/net/udp6"}) {
    std::ifstream stream{table};
    std::string line;
    std::getline(stream, line);  // skips the heading
    while (std::getline(stream, line)) {
      std::istringstream words{line};
      std::string slot, local;
      words >> slot >> local;
      const std::size_t colon = local.rfind(':');
      if (colon == std::string::npos) continue;
      ports.push_back(static_cast<std::uint16_t>(std::stoul(local.substr(colon + 1), nullptr, 16)));
    }
  }
  std::sort(ports.begin(), ports.end());
  ports.erase(std::unique(ports.begin(), ports.end()), ports.end());
  return ports;
}

std::vector<std::string> own_addresses() {
  std::vector<std::string> addresses;
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return addresses;
  for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
    if (inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) != nullptr)
      addresses.emplace_back(text.data());
  }
  freeifaddrs(first);
  return addresses;
}

std::uint64_t limit(int resource) {
  rlimit limits{};
  return getrlimit(static_cast<__rlimit_resource>(resource), &limits) == 0 ? limits.rlim_cur : 0;
}

void look_at_shared_memory(HostFacts& facts) {
  struct statvfs room {};
  facts.shared_memory_writable = statvfs("/dev/shm", &room) == 0 && access("/dev/shm", W_OK) == 0;
  facts.shared_memory_free_bytes = std::uint64_t{room.f_bavail} * room.f_frsize;
  for (const runtime::LeftFile& file : runtime::left_by_the_dead()) {
    ++facts.left_files;
    facts.left_bytes += file.bytes;
  }
}

void look_at_ports(HostFacts& facts) {
  facts.domain_in_use = runtime::has_living_ports(facts.domain);
  facts.udp_ports_in_use = udp_ports();
  const auto range = numbers_in("/proc/sys/net/ipv4/ip_local_port_range");
  if (range.size() == 2) {
    facts.ephemeral_first = static_cast<std::uint16_t>(range[0]);
    facts.ephemeral_last = static_cast<std::uint16_t>(range[1]);
  }
  facts.addresses = own_addresses();
}

void look_at_clock(HostFacts& facts) {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  facts.clock_s = std::chrono::duration_cast<std::chrono::seconds>(since_1970).count();
  timex kernel{};
  facts.clock_synchronised = adjtimex(&kernel) != TIME_ERROR && (kernel.status & STA_UNSYNC) == 0;
}

}  // namespace

HostFacts look_at_host(std::uint32_t robots, std::uint32_t domain, const runtime::Transport& transport) {
  HostFacts facts;
  facts.robots = robots;
  facts.domain = domain;
  facts.reach = runtime::reach_of(transport);
  facts.missing_programs = missing_programs();
  facts.dds_built = runtime::dds_version();
  facts.dds_loaded = loaded_dds();
  facts.server_profile = runtime::data_folder() / "fastdds/discovery_server.xml";
  look_at_shared_memory(facts);
  look_at_ports(facts);
  look_at_clock(facts);
  facts.open_files = limit(RLIMIT_NOFILE);
  facts.threads = limit(RLIMIT_NPROC);
  facts.socket_receive_bytes = number_in("/proc/sys/net/core/rmem_max");
  facts.socket_send_bytes = number_in("/proc/sys/net/core/wmem_max");
  return facts;
}

}  // namespace caravan::deploy
