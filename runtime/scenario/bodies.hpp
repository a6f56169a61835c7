// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Robots behind a bridge, as --bodies of world server and radio emulator names them: sorted.
/// @throws StartError for numbers that are not 1 to `robots`
[[nodiscard]] std::vector<std::uint32_t> read_bodies(const std::vector<std::string>& lists,
                                                     std::uint32_t robots);

}  // namespace caravan::runtime
