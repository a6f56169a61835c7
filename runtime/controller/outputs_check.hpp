// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <string>

namespace caravan::runtime {

/// The first value of a step's outputs that exceeds the limits of the interface (caravan/types.hpp), and the
/// limit. Empty: none.
/// @param now  of the step
[[nodiscard]] std::string fault_in(const Outputs& outputs, Time now);

}  // namespace caravan::runtime
