// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace caravan::test {

/// Placement of a run's processes, as options of `caravan run`.
struct Placement {
  std::string name;
  std::vector<std::string> options;
  int repetitions = 1;
};

std::ostream& operator<<(std::ostream& out, const Placement& placement);

inline const std::vector<std::string> kEmbedded{"--engine", "embedded"};

[[nodiscard]] inline std::string name_of_placement(const testing::TestParamInfo<Placement>& info) {
  return info.param.name;
}

/// Runs the scenario and returns the digest of the run; empty if it was disturbed or failed.
[[nodiscard]] std::string digest_of(const std::string& scenario_name,
                                    const std::vector<std::string>& placement,
                                    const std::vector<std::string>& experiment);

}  // namespace caravan::test
