// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/trace/steps.hpp"

namespace caravan::experiment {

/// A value that is not the same in two runs, to the last bit.
struct Difference {
  std::uint64_t robot = 0;  ///< 0: of the step as a whole
  std::string quantity;     ///< such as command.left_mps
  std::string one;          ///< what the first run says
  std::string other;
};

/// What a run recorded of one step.
struct TracedStep {
  WorldStep world;
  RadioStep radio;
};

/// Everything in which two steps differ, in the order in which one thing leads to another: which robots were
/// put elsewhere, what robots were told to do, what they sent, what they heard, where they got to; each by
/// robot.
[[nodiscard]] std::vector<Difference> differences(const TracedStep& one, const TracedStep& other);

}  // namespace caravan::experiment
