// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// `caravan ctl`: sends one request to the world or radio in a DDS domain, and prints the result.
///
/// @param words  as in control_forms(); `status` prints the state of the world
/// @return the exit code: 0 done or scheduled, 1 refused or not answered
/// @throws runtime::StartError when the words are not a request
[[nodiscard]] int run_ctl(std::uint32_t domain, runtime::Transport transport,
                          const std::vector<std::string>& words);

/// The forms, one per line, for --help.
[[nodiscard]] std::string ctl_help();

}  // namespace caravan::deploy
