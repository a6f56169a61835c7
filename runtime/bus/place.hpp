// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// The shared-memory port at which new processes reach this one, and the discovery of the ports of others.
///
/// By default all DDS processes listen for new ones at one port. A killed process leaves a place there that
/// nobody reads; it fills up, and then a joining process hangs. Here each process listens at its own port,
/// whose number is in the name of a local socket. The kernel removes the name as soon as the process has
/// ended, however it ended.
class Place {
 public:
  /// @throws StartError when local sockets are not available
  explicit Place(std::uint32_t domain);
  ~Place();
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// Makes DDS listen at this place and announce itself at those of the other processes.
  ///
  /// Of two processes that start at the same moment at least one finds the other; the answer to its
  /// announcement introduces it there too. @param own  GUID of the participant
  void settle(rtps::BuiltinAttributes& discovery, const rtps::GUID_t& own) const;

 private:
  std::uint32_t domain_;
  std::uint32_t port_ = 0;
  int held_ = -1;  // the socket
};

/// Ports of all places of the domain: one for each process in it over shared memory, of any user.
[[nodiscard]] std::vector<std::uint32_t> places_in(std::uint32_t domain);

}  // namespace caravan::runtime
