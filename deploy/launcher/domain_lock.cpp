// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/domain_lock.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>

#include "deploy/launcher/shared_memory.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

// Low domains are what people type by hand; 232 is DDS's last.
constexpr std::uint32_t kFirst = 100;
constexpr std::uint32_t kLast = 229;

/// The locked file, or -1 when another run holds it.
int try_lock(std::uint32_t domain) {
  const std::string name =
      std::filesystem::temp_directory_path() / ("caravan_domain_" + std::to_string(domain) + ".lock");
  const int file = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return -1;
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  close(file);
  return -1;
}

/// Whether somebody has the domain's first UDP port on this machine: a DDS program of another kind is there.
bool has_udp_port(std::uint32_t domain) {
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(7410 + 250 * domain));
  const bool taken = bind(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
  close(probe);
  return taken;
}

}  // namespace

DomainLock::DomainLock(std::optional<std::uint32_t> wanted) {
  if (wanted) {
    domain_ = *wanted;
    file_ = try_lock(domain_);
    if (file_ >= 0) remove_dead_ports(domain_);
    return;
  }
  for (domain_ = kFirst; domain_ <= kLast; ++domain_) {
    file_ = try_lock(domain_);
    if (file_ < 0) continue;
    if (!has_living_ports(domain_) && !has_udp_port(domain_)) {
      remove_dead_ports(domain_);
      return;
    }
    close(std::exchange(file_, -1));  // somebody who takes no locks works here
  }
  throw runtime::StartError{"no free DDS domain: every one from " + std::to_string(kFirst) + " to " +
                            std::to_string(kLast) + " is in use"};
}

DomainLock::~DomainLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace caravan::deploy
