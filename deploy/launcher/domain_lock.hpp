// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace caravan::deploy {

/// A DDS domain that no other run on this machine uses, held until destruction.
///
/// Dead processes' ports in it are removed first. The lock is a file in the temporary directory, shared by
/// all users; it names the domain and ends with the process.
class DomainLock {
 public:
  /// @param wanted  this one, whether others use it or not; none: a free one
  /// @throws StartError when every domain is taken
  explicit DomainLock(std::optional<std::uint32_t> wanted);
  ~DomainLock();
  DomainLock(const DomainLock&) = delete;
  DomainLock& operator=(const DomainLock&) = delete;

  [[nodiscard]] std::uint32_t domain() const { return domain_; }

 private:
  std::uint32_t domain_ = 0;
  int file_ = -1;
};

}  // namespace caravan::deploy
