// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "robot_agent/core/radio/frames/messages.hpp"

namespace caravan::agent {

/// The notation of the paper's logs (section 3.2): `WAIT_3_EXPLORE`, `ACCEPT_7-3`, `ACCEPTACK_3-7`,
/// `REJECT_3-7`, `END_7-3`. A path fragment is `PATH_7-3_20..39/50`.
[[nodiscard]] std::string to_text(const Message& message);

}  // namespace caravan::agent
