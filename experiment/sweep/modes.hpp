// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace caravan::experiment {

/// The modes that a text such as `none,full` names, in the order given.
///
/// @throws runtime::StartError when it names something that is no mode, or one twice
[[nodiscard]] std::vector<std::string> read_modes(const std::string& text);

}  // namespace caravan::experiment
