// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "deploy/doctor/facts.hpp"
#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// Collects the facts of this host that the present user may read.
/// @throws runtime::StartError when the transport is a profile that cannot be read
[[nodiscard]] HostFacts look_at_host(std::uint32_t robots, std::uint32_t domain,
                                     const runtime::Transport& transport);

}  // namespace caravan::deploy
