// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace eprosima::fastrtps::rtps {
class BuiltinAttributes;
}

namespace caravan::runtime {

/// So many processes of a domain may live on a machine at one time: each has two of DDS's 250 ports.
inline constexpr std::uint32_t kMostProcesses = 120;

/// A number, from 0 on, that a process has for itself among those that find one another over 127.0.0.1.
///
/// It is held by a UDP port, so it is free again as soon as the process has ended, however it did.
class Place {
 public:
  /// @throws StartError when the domain has no more of them
  explicit Place(std::uint32_t domain);
  ~Place();
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// Has DDS listen for newcomers at the place's own port, and announce itself to those that are there.
  ///
  /// Of two that start in the same moment the one with the higher place always knows of the lower; the answer
  /// to its announcement makes it known there too.
  void settle(eprosima::fastrtps::rtps::BuiltinAttributes& discovery) const;

 private:
  std::uint32_t domain_;
  std::uint32_t number_ = 0;
  int held_ = -1;  // the socket
};

}  // namespace caravan::runtime
