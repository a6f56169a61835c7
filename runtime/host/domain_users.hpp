// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <ctime>
#include <optional>
#include <string>

namespace caravan::runtime {

/// The process that holds a DomainLock.
struct DomainHolder {
  pid_t pid = 0;  ///< in its own PID namespace; a container may number it differently
  uid_t user = 0;
  std::time_t since = 0;
};

/// The holder of the domain's lock; none: it is free.
[[nodiscard]] std::optional<DomainHolder> holder_of(std::uint32_t domain);
/// Its user's name, or "user 1234" when it has none.
[[nodiscard]] std::string user_text(uid_t user);
/// "pid 12, user alice, since 2026-11-23 09:25:40"
[[nodiscard]] std::string to_text(const DomainHolder& holder);

/// Another user of this machine who holds the domain's lock or has a process in it over shared memory.
/// Processes of two users cannot use each other's shared memory, so they cannot join; they only disturb each
/// other.
[[nodiscard]] std::optional<uid_t> other_user_in(std::uint32_t domain);

/// Local names (runtime/bus/local_names.hpp) of the domain's lock and of its holder.
[[nodiscard]] std::string lock_name(std::uint32_t domain);
[[nodiscard]] std::string holder_name(std::uint32_t domain, const DomainHolder& holder);

}  // namespace caravan::runtime
