// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/domain_users.hpp"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <sstream>

#include "runtime/bus/local_names.hpp"
#include "runtime/bus/place.hpp"
#include "runtime/bus/shared_memory_port.hpp"

namespace caravan::runtime {
namespace {

/// Parses `pid/user/since`, the end of a holder_name().
std::optional<DomainHolder> holder_in(const std::string& text) {
  std::istringstream in{text};
  DomainHolder holder;
  char slash = 0;
  char other_slash = 0;
  if (!(in >> holder.pid >> slash >> holder.user >> other_slash >> holder.since)) return std::nullopt;
  return holder;
}

}  // namespace

std::string lock_name(std::uint32_t domain) { return "caravan_domain/" + std::to_string(domain); }

std::string holder_name(std::uint32_t domain, const DomainHolder& holder) {
  return lock_name(domain) + "/" + std::to_string(holder.pid) + "/" + std::to_string(holder.user) + "/" +
         std::to_string(holder.since);
}

std::optional<DomainHolder> holder_of(std::uint32_t domain) {
  for (const std::string& name : local_names(lock_name(domain) + "/")) return holder_in(name);
  return std::nullopt;
}

std::string user_text(uid_t user) {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> room{};
  if (getpwuid_r(user, &entry, room.data(), room.size(), &found) == 0 && found != nullptr)
    return found->pw_name;
  return "user " + std::to_string(user);
}

std::string to_text(const DomainHolder& holder) {
  std::tm local{};
  localtime_r(&holder.since, &local);
  std::array<char, 32> since{};
  std::strftime(since.data(), since.size(), "%Y-%m-%d %H:%M:%S", &local);
  return "pid " + std::to_string(holder.pid) + ", user " + user_text(holder.user) + ", since " + since.data();
}

std::optional<uid_t> other_user_in(std::uint32_t domain) {
  if (const auto holder = holder_of(domain); holder && holder->user != geteuid()) return holder->user;
  for (const std::uint32_t port : places_in(domain)) {
    struct stat facts {};
    const std::string file = port_file(port);
    if (stat(file.c_str(), &facts) == 0 && facts.st_uid != geteuid()) return facts.st_uid;
  }
  return std::nullopt;
}

}  // namespace caravan::runtime
