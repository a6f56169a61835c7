// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/bus/reach.hpp"

namespace caravan::deploy {

/// The facts of a host, and the run that is wanted on it.
struct HostFacts {
  // wanted
  std::uint32_t robots = 15;
  std::uint32_t domain = 0;
  runtime::Reach reach = {};  ///< of the transport

  // programs
  std::vector<std::string> missing_programs;  ///< programs missing beside `caravan`
  std::string dds_built;                      ///< version that the program was built with
  std::string dds_loaded;                     ///< version that it runs with; empty: unknown
  std::string server_profile;                 ///< profile of a Discovery Server

  // shared memory: /dev/shm
  bool shared_memory_writable = true;
  std::uint64_t shared_memory_free_bytes = 0;
  std::size_t left_files = 0;  ///< DDS files of processes that are gone
  std::uint64_t left_bytes = 0;

  // ports
  bool domain_in_use = false;  ///< a running process has DDS ports of the domain in shared memory
  std::vector<std::uint16_t> udp_ports_in_use;  ///< of the whole host, sorted
  std::uint16_t ephemeral_first = 0;            ///< ports that the kernel assigns by itself
  std::uint16_t ephemeral_last = 0;
  std::vector<std::string> addresses;  ///< of the host's interfaces

  // clock
  std::int64_t clock_s = 0;  ///< since 1970
  bool clock_synchronised = true;

  // limits of this user
  std::uint64_t open_files = 0;
  std::uint64_t threads = 0;
  std::uint64_t socket_receive_bytes = 0;  ///< the most that a socket may request
  std::uint64_t socket_send_bytes = 0;
};

}  // namespace caravan::deploy
