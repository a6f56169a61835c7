// SPDX-License-Identifier: Apache-2.0
#include "deploy/doctor/findings.hpp"

#include <algorithm>

namespace caravan::deploy {
namespace {

using Severity = Finding::Severity;

constexpr std::int64_t kDebian12_s = 1'686'355'200;  // 2023-06-10: a correct clock cannot be earlier
constexpr std::uint64_t kOpenFilesAtLeast = 256;
constexpr std::uint64_t kOpenFiles = 1024;
constexpr std::uint64_t kThreadsOfAProcess = 12;
constexpr std::uint64_t kProcessesBesideAgents = 4;  // world, radio, launcher, and one spare

std::string megabytes(std::uint64_t bytes) { return std::to_string((bytes + (1 << 19)) >> 20) + " MB"; }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::uint64_t processes(const HostFacts& facts) { return facts.robots + kProcessesBesideAgents; }

Finding programs(const HostFacts& facts) {
  if (facts.missing_programs.empty()) return {Severity::kGood, "programs", "all there", ""};
  return {Severity::kProblem, "programs", "missing beside caravan: " + listed(facts.missing_programs),
          "build or install them into the same folder"};
}

Finding library(const HostFacts& facts) {
  const std::string subject = "Fast DDS";
  if (facts.dds_loaded.empty())
    return {Severity::kWarning, subject, "built with " + facts.dds_built + ", runs with an unknown version",
            "check with ldd which Fast DDS library is used"};
  if (facts.dds_loaded == facts.dds_built) return {Severity::kGood, subject, facts.dds_loaded, ""};
  const auto minor = [](const std::string& version) { return version.substr(0, version.rfind('.')); };
  const bool close = minor(facts.dds_loaded) == minor(facts.dds_built);
  return {close ? Severity::kWarning : Severity::kProblem, subject,
          "built with " + facts.dds_built + ", runs with " + facts.dds_loaded,
          "build again, or install Fast DDS " + facts.dds_built};
}

Finding shared_memory(const HostFacts& facts) {
  const std::string subject = "shared memory";
  const std::string free = megabytes(facts.shared_memory_free_bytes) + " free in /dev/shm";
  if (!facts.reach.shared_memory) return {Severity::kGood, subject, "not used by this transport", ""};
  if (!facts.shared_memory_writable)
    return {Severity::kProblem, subject, "/dev/shm is not writable",
            "mount a tmpfs there (containers: --ipc=host), or use --transport udp"};
  const std::uint64_t needed = processes(facts) * kSharedMemoryOfAProcess;
  if (facts.shared_memory_free_bytes >= needed) return {Severity::kGood, subject, free, ""};
  return {Severity::kProblem, subject,
          free + ", " + std::to_string(facts.robots) + " robots need " + megabytes(needed),
          "mount -o remount,size=512M /dev/shm (containers: --ipc=host or --shm-size=512m)"};
}

Finding left_over(const HostFacts& facts) {
  const std::string subject = "left over";
  if (facts.left_files == 0) return {Severity::kGood, subject, "nothing in /dev/shm", ""};
  return {Severity::kWarning, subject,
          std::to_string(facts.left_files) + " files, " + megabytes(facts.left_bytes) +
              " in /dev/shm, of processes that are gone",
          "caravan doctor --clean"};
}

/// DDS ports of the domain: 250 numbers per domain, from 7400 on.
std::pair<std::uint32_t, std::uint32_t> ports_of(std::uint32_t domain) {
  return {7400 + 250 * domain, 7400 + 250 * domain + 249};
}

Finding domain(const HostFacts& facts) {
  const std::string subject = "domain " + std::to_string(facts.domain);
  const auto [first, last] = ports_of(facts.domain);
  const auto taken =
      std::count_if(facts.udp_ports_in_use.begin(), facts.udp_ports_in_use.end(),
                    [from = first, to = last](std::uint16_t port) { return port >= from && port <= to; });
  if (facts.domain_in_use || taken > 0)
    return {Severity::kWarning, subject, "in use",
            "choose another --domain unless these processes belong to yours"};
  const bool may_collide =
      facts.reach.network && first <= facts.ephemeral_last && last >= facts.ephemeral_first;
  if (may_collide)
    return {Severity::kWarning, subject,
            "its ports " + std::to_string(first) + " to " + std::to_string(last) +
                " may also be assigned to other programs",
            "choose a --domain below " + std::to_string((facts.ephemeral_first - 7400) / 250) +
                ", or narrow net.ipv4.ip_local_port_range"};
  return {Severity::kGood, subject, "free", ""};
}

Finding interfaces(const HostFacts& facts) {
  const std::string subject = "interfaces";
  if (!facts.reach.network) return {Severity::kGood, subject, "not used by this transport", ""};
  std::vector<std::string> missing;
  for (const std::string& wanted : facts.reach.interfaces) {
    if (!contains(facts.addresses, wanted)) missing.push_back(wanted);
  }
  if (!missing.empty())
    return {Severity::kProblem, subject, "not an address of this host: " + listed(missing),
            "correct interfaceWhiteList in the profile; this host has " + listed(facts.addresses)};
  return {Severity::kGood, subject,
          listed(facts.reach.interfaces.empty() ? facts.addresses : facts.reach.interfaces), ""};
}

Finding discovery(const HostFacts& facts) {
  const std::string subject = "discovery";
  if (facts.reach.servers.empty()) return {Severity::kGood, subject, "needs no server", ""};
  std::vector<std::string> names;
  for (const auto& server : facts.reach.servers) {
    names.push_back(server.address + ":" + std::to_string(server.port));
    const bool bound =
        std::binary_search(facts.udp_ports_in_use.begin(), facts.udp_ports_in_use.end(), server.port);
    if (contains(facts.addresses, server.address) && !bound)
      return {Severity::kProblem, subject,
              "no Discovery Server at " + names.back() + ", an address of this host",
              "fast-discovery-server -i 0 -l " + server.address + " -p " + std::to_string(server.port) +
                  " -x " + facts.server_profile};
  }
  return {Severity::kGood, subject, "server " + listed(names), ""};
}

Finding clock(const HostFacts& facts) {
  if (facts.clock_s < kDebian12_s)
    return {Severity::kProblem, "clock", "set before 2023", "set it: timedatectl, or an NTP service"};
  if (!facts.clock_synchronised)
    return {Severity::kWarning, "clock", "not synchronised: logs of several hosts cannot be compared",
            "enable systemd-timesyncd or chrony; runs themselves do not depend on it"};
  return {Severity::kGood, "clock", "synchronised", ""};
}

Finding open_files(const HostFacts& facts) {
  const std::string seen = std::to_string(facts.open_files);
  if (facts.open_files >= kOpenFiles) return {Severity::kGood, "open files", seen, ""};
  return {facts.open_files < kOpenFilesAtLeast ? Severity::kProblem : Severity::kWarning, "open files", seen,
          "ulimit -n " + std::to_string(kOpenFiles) + " (systemd: LimitNOFILE=)"};
}

Finding threads(const HostFacts& facts) {
  const std::uint64_t needed = processes(facts) * kThreadsOfAProcess;
  const std::string seen = std::to_string(facts.threads);
  if (facts.threads >= needed) return {Severity::kGood, "threads", seen, ""};
  return {
      Severity::kProblem, "threads",
      seen + ", " + std::to_string(facts.robots) + " robots need " + std::to_string(needed),
      "ulimit -u " + std::to_string(2 * needed) + " (systemd: TasksMax=), or several robots in a process"};
}

Finding sockets(const HostFacts& facts) {
  const std::string subject = "socket buffers";
  if (!facts.reach.network) return {Severity::kGood, subject, "not used by this transport", ""};
  const std::uint64_t least = std::min(facts.socket_receive_bytes, facts.socket_send_bytes);
  const std::string seen = std::to_string(least / 1024) + " KiB";
  if (least >= kSocketBytes) return {Severity::kGood, subject, seen, ""};
  const std::string wanted = std::to_string(kSocketBytes);
  return {Severity::kWarning, subject, seen + ": large fleets lose packets and wait for retransmission",
          "sysctl -w net.core.rmem_max=" + wanted + " net.core.wmem_max=" + wanted};
}

}  // namespace

std::vector<Finding> examine(const HostFacts& facts) {
  return {programs(facts),   library(facts),    shared_memory(facts), left_over(facts),
          domain(facts),     interfaces(facts), discovery(facts),     clock(facts),
          open_files(facts), threads(facts),    sockets(facts)};
}

}  // namespace caravan::deploy
