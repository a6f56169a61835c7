// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/domain_lock.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <string>
#include <utility>

#include "runtime/bus/local_names.hpp"
#include "runtime/bus/place.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/host/domain_users.hpp"
#include "runtime/host/shared_memory.hpp"

namespace caravan::runtime {
namespace {

// Low domains are what people type by hand; 232 is DDS's last.
constexpr std::uint32_t kFirst = 100;
constexpr std::uint32_t kLast = 229;

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

bool is_in_use(std::uint32_t domain) {
  return has_living_ports(domain) || !places_in(domain).empty() || has_udp_port(domain);
}

/// 0: there is none, or it cannot be read.
pid_t parent_of(pid_t process) {
  std::ifstream status{"/proc/" + std::to_string(process) + "/status"};
  for (std::string word; status >> word;) {
    pid_t parent = 0;
    if (word == "PPid:" && status >> parent) return parent;
  }
  return 0;
}

bool is_ancestor(pid_t process) {
  for (pid_t one = getppid(); one > 0; one = parent_of(one)) {
    if (one == process) return true;
  }
  return false;
}

[[noreturn]] void refuse(std::uint32_t domain, const std::string& why) {
  throw StartError{"DDS domain " + std::to_string(domain) + ": " + why +
                   "; end that one or choose another --domain"};
}

}  // namespace

DomainLock::DomainLock(std::optional<std::uint32_t> wanted) {
  if (wanted) {
    take(*wanted);
    return;
  }
  for (domain_ = kFirst; domain_ <= kLast; ++domain_) {
    if (!lock(domain_)) continue;
    if (!is_in_use(domain_)) {
      remove_dead_ports(domain_);
      return;
    }
    unlock();  // somebody who takes no locks works here
  }
  throw StartError{"no free DDS domain: every one from " + std::to_string(kFirst) + " to " +
                   std::to_string(kLast) + " is in use"};
}

DomainLock::~DomainLock() { unlock(); }

void DomainLock::take(std::uint32_t wanted) {
  domain_ = wanted;
  if (!lock(wanted)) {
    const auto holder = holder_of(wanted);
    if (holder && is_ancestor(holder->pid)) return;
    refuse(wanted, holder ? "another run or world holds it (" + to_text(*holder) + ")"
                          : "another run or world holds it");
  }
  if (const auto other = other_user_in(wanted)) {
    unlock();
    refuse(wanted, "processes of another user are in it (" + user_text(*other) + ")");
  }
  remove_dead_ports(wanted);
}

bool DomainLock::lock(std::uint32_t domain) {
  sockets_[0] = hold_local_name(lock_name(domain));
  if (sockets_[0] < 0) return false;
  sockets_[1] = hold_local_name(holder_name(domain, {getpid(), geteuid(), std::time(nullptr)}));
  return true;
}

void DomainLock::unlock() {
  for (int& held : sockets_) {
    if (held >= 0) close(std::exchange(held, -1));
  }
}

}  // namespace caravan::runtime
