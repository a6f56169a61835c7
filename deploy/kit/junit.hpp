// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caravan::deploy {

/// One line of a test report.
struct Verdict {
  enum class Kind : std::uint8_t { kGood, kFailed, kSkipped };
  std::string name;
  Kind kind = Kind::kGood;
  std::string text;  ///< why it failed
  double took_s = 0.0;
};

/// A report in JUnit XML, which continuous integration servers read.
[[nodiscard]] std::string to_junit(const std::string& suite, const std::vector<Verdict>& verdicts);

}  // namespace caravan::deploy
