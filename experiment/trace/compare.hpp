// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/trace/steps.hpp"

namespace caravan::experiment {

/// A value that differs between two runs in at least one bit.
struct Difference {
  std::uint64_t robot = 0;  ///< 0: the step as a whole
  std::string quantity;     ///< such as command.left_mps
  std::string one;          ///< value in the first run
  std::string other;
};

/// A run's record of one step.
struct TracedStep {
  WorldStep world;
  RadioStep radio;
};

/// All differences between two steps, in causal order: robots that were moved, commands, transmissions,
/// receptions, resulting poses; each sorted by robot.
[[nodiscard]] std::vector<Difference> differences(const TracedStep& one, const TracedStep& other);
/// Of the answers of robot `robot`; reports are not compared, because the run does not depend on them.
[[nodiscard]] std::vector<Difference> differences(std::uint64_t robot, const caravan::Outputs& one,
                                                  const caravan::Outputs& other);

}  // namespace caravan::experiment
