// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// `caravan doctor`: checks whether this host is ready for a run.
struct DoctorRequest {
  std::uint32_t robots = 15;
  std::uint32_t domain = 0;
  runtime::Transport transport = {};
  bool clean = false;  ///< first removes what dead processes left in shared memory
};

/// Prints its findings with advice. @return 0: no problem, 1: a problem
/// @throws runtime::StartError when the transport is a profile that cannot be read
[[nodiscard]] int run_doctor(const DoctorRequest& request);

}  // namespace caravan::deploy
