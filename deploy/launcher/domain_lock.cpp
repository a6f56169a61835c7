// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/domain_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
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
    if (!has_living_ports(domain_)) {
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
