// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// The port of shared memory at which newcomers find a process, and the means to find those that are there.
///
/// Left to itself DDS has all processes listen for newcomers at one port, where a killed one leaves a place
/// from which nobody reads any more; it fills up, and then hangs whoever comes. So each listens at a port of
/// its own, whose number is in the name of a local socket. The kernel takes the name away as soon as the
/// process has ended, however it did.
class Place {
 public:
  /// @throws StartError when there are no local sockets
  explicit Place(std::uint32_t domain);
  ~Place();
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// Has DDS listen at this place and announce itself at those of the others that are there.
  ///
  /// Of two that start in the same moment at least one knows of the other; the answer to its announcement
  /// makes it known there too. @param own  of the participant
  void settle(rtps::BuiltinAttributes& discovery, const rtps::GUID_t& own) const;

 private:
  std::uint32_t domain_;
  std::uint32_t port_ = 0;
  int held_ = -1;  // the socket
};

/// Ports of all places of the domain: one for each process that is in it by shared memory, whoever's it is.
[[nodiscard]] std::vector<std::uint32_t> places_in(std::uint32_t domain);

}  // namespace caravan::runtime
