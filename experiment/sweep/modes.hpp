// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace caravan::experiment {

/// Reads a list of modes such as `none,full`; keeps the order.
///
/// @throws runtime::StartError for an unknown mode or one that is named twice
[[nodiscard]] std::vector<std::string> read_modes(const std::string& text);

}  // namespace caravan::experiment
