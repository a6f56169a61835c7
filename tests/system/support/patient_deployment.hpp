// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <string>

#include <caravan/deployment_test.hpp>
#include "tests/support/patience.hpp"

namespace caravan::test {

/// The fixture of the kit, except that `happens` waits longer on a busy machine.
class PatientDeployment : public deploy::DeploymentTest {
 protected:
  template <typename Wanted>
  [[nodiscard]] ::testing::AssertionResult happens(const std::string& name, const Wanted& wanted,
                                                   std::chrono::milliseconds within = kPatience) {
    const auto began = std::chrono::steady_clock::now();
    Patience patience{within};
    for (;;) {
      ::testing::AssertionResult result = DeploymentTest::happens(name, wanted, std::min(within, kLook));
      if (result || patience.is_over()) return result << waited_since(began);
    }
  }

 private:
  static constexpr std::chrono::milliseconds kLook{200};

  static std::string waited_since(std::chrono::steady_clock::time_point began) {
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - began;
    return "\n  " + std::to_string(waited.count()) + " s in all; the machine is slower now by " +
           std::to_string(slowness());
  }
};

}  // namespace caravan::test
