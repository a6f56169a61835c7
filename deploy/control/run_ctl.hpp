// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/bus/transport.hpp"

namespace caravan::deploy {

/// `caravan ctl`: asks one thing of the world or radio in a DDS domain, and prints what became of it.
///
/// @param words  as in control_forms(); `status` prints how the world is
/// @return the exit code: 0 done or scheduled, 1 refused or not answered
/// @throws runtime::StartError when the words are no request
[[nodiscard]] int run_ctl(std::uint32_t domain, runtime::Transport transport,
                          const std::vector<std::string>& words);

/// The forms, one a line, for --help.
[[nodiscard]] std::string ctl_help();

}  // namespace caravan::deploy
