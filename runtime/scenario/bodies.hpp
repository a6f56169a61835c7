// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Robots behind a bridge, from --bodies of world server and radio emulator, sorted.
/// @throws StartError for numbers outside 1 to `robots`
[[nodiscard]] std::vector<std::uint32_t> read_bodies(const std::vector<std::string>& lists,
                                                     std::uint32_t robots);

}  // namespace caravan::runtime
