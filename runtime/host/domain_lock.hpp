// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace caravan::runtime {

/// A DDS domain that no other run on this machine uses, nor a world that was started by hand; held until
/// destruction.
///
/// Dead processes' ports in it are removed first. The lock is a local socket in the kernel's own name space:
/// it is in no folder, counts for all users, and ends with the process, however that ends. A second one tells
/// who holds it (domain_users.hpp).
///
/// A process may also take the domain that its parent holds: who starts a run may choose the domain first.
class DomainLock {
 public:
  /// @param wanted  this one; none: a free one
  /// @throws StartError when another run holds the wanted one or another user's processes are in it, naming
  ///         them; when every domain is taken
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
  std::array<int, 2> sockets_{-1, -1};  // the lock, and who holds it
};

}  // namespace caravan::runtime
