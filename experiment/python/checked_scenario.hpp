// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// Keys of a scenario, such as `radio.range_m`, and their new values as TOML.
using Changes = std::vector<std::pair<std::string, std::string>>;

/// A scenario that no program would refuse, but for its controller.
struct CheckedScenario {
  std::string text;
  RunFacts facts;
};

/// Reads every table of a scenario but [controller] as the programs do, and builds the world once. With
/// changes the text is another one, in which the path of a controller is absolute.
///
/// @param file  the scenario's name in messages; relative paths start from its folder
/// @throws runtime::StartError; for a change it begins with `changed key=value`
[[nodiscard]] CheckedScenario check_scenario(const std::string& text, const std::string& file,
                                             const Changes& changes);

}  // namespace caravan::experiment
