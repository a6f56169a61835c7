// SPDX-License-Identifier: Apache-2.0
#include "tests/system/support/digest_of.hpp"

#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/system/support/process.hpp"

namespace caravan::test {

std::ostream& operator<<(std::ostream& out, const Placement& placement) {
  out << "caravan run";
  for (const std::string& option : placement.options) out << ' ' << option;
  return out;
}

std::string digest_of(const std::string& scenario_name, const std::vector<std::string>& placement,
                      const std::vector<std::string>& experiment) {
  const ScratchFolder folder;
  std::vector<std::string> line{"caravan", "run",   scenario(scenario_name),
                                "--quiet", "--out", folder / "out"};
  line.insert(line.end(), placement.begin(), placement.end());
  line.insert(line.end(), experiment.begin(), experiment.end());
  Process process{line, folder / "caravan.log"};
  EXPECT_TRUE(process.wait(std::chrono::minutes{30})) << process.output();
  const auto metrics = nlohmann::json::parse(read_file(folder / "out/metrics.json"), nullptr, false);
  if (metrics.is_discarded()) {
    ADD_FAILURE() << "no metrics: " << process.output();
    return "";
  }
  EXPECT_EQ(metrics.at("failure"), "");
  EXPECT_FALSE(metrics.at("disturbed"));
  std::string digest = metrics.at("digest");
  EXPECT_NE(digest, "");
  std::cout << digest << " after " << metrics.at("wall_time_s") << " s\n";
  return digest;
}

}  // namespace caravan::test
