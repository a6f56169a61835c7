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
  pid_t pid = 0;  ///< as it counts itself; a container may count differently
  uid_t user = 0;
  std::time_t since = 0;
};

/// Who holds the domain's lock; none: nobody.
[[nodiscard]] std::optional<DomainHolder> holder_of(std::uint32_t domain);
/// Its user's name, or "user 1234" when it has none.
[[nodiscard]] std::string user_text(uid_t user);
/// "pid 12, user alice, since 2026-11-23 09:25:40"
[[nodiscard]] std::string to_text(const DomainHolder& holder);

/// Another user of this machine who holds the domain's lock or has a process in it by shared memory.
/// Processes of two users cannot use each other's shared memory, so they do not join: they are only in each
/// other's way.
[[nodiscard]] std::optional<uid_t> other_user_in(std::uint32_t domain);

/// The domain's lock, and with it who holds it, as local names (runtime/bus/local_names.hpp).
[[nodiscard]] std::string lock_name(std::uint32_t domain);
[[nodiscard]] std::string holder_name(std::uint32_t domain, const DomainHolder& holder);

}  // namespace caravan::runtime
