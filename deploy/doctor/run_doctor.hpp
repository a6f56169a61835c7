// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// `caravan doctor`: is this host fit for a run?
struct DoctorRequest {
  std::uint32_t robots = 15;
  std::uint32_t domain = 0;
  runtime::Transport transport = {};
  bool clean = false;  ///< remove what dead processes left in shared memory, before looking
};

/// Prints what it finds and what to do about it. @return 0 nothing stands in the way, 1 something does
/// @throws runtime::StartError when the transport is a profile that cannot be read
[[nodiscard]] int run_doctor(const DoctorRequest& request);

}  // namespace caravan::deploy
