// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caravan::agent {

/// The robots of a list such as "1-15" or "1,3,5-8", sorted.
/// @throws StartError when it is written otherwise, names a robot twice, or one beyond 65535
[[nodiscard]] std::vector<std::uint32_t> parse_robot_list(const std::string& text);

}  // namespace caravan::agent
