// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <string>

namespace caravan::experiment {

// Whole values of one step of a controller, for `caravan step-agent --step`: lines `name  value`.

/// Position, sonars, wheels, frames heard, and the rest of what a step is given, except the time.
[[nodiscard]] std::string text_of(const caravan::Inputs& inputs);
/// Without Outputs::report, which traces do not have.
[[nodiscard]] std::string text_of(const caravan::Outputs& outputs);

}  // namespace caravan::experiment
