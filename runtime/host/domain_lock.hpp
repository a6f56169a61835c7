// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace caravan::runtime {

/// A DDS domain that no other run on this machine uses, nor a world that was started by hand; held until
/// destruction.
///
/// Ports of dead processes in the domain are removed first. The lock is a local socket in the kernel's own
/// name space: it is in no folder, applies to all users, and ends with the process, however that ends. A
/// second socket names the holder (domain_users.hpp).
///
/// A process may also take the domain that one of its ancestors holds: the starter of a run may choose the
/// domain first, and the world of a run has the run's.
class DomainLock {
 public:
  /// @param wanted  the domain to take; none: any free one
  /// @throws StartError when another run holds the wanted domain or another user's processes are in it,
  /// naming them; when no domain is free
  explicit DomainLock(std::optional<std::uint32_t> wanted);
  ~DomainLock();
  DomainLock(const DomainLock&) = delete;
  DomainLock& operator=(const DomainLock&) = delete;

  [[nodiscard]] std::uint32_t domain() const { return domain_; }

 private:
  void take(std::uint32_t wanted);
  /// False: another run holds it.
  [[nodiscard]] bool lock(std::uint32_t domain);
  void unlock();

  std::uint32_t domain_ = 0;
  std::array<int, 2> sockets_{-1, -1};  // the lock, and the holder's name
};

}  // namespace caravan::runtime
