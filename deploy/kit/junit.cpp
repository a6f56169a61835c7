// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/junit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace caravan::deploy {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char one : text) {
    switch (one) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        // XML 1.0 has no other control characters.
        safe += static_cast<unsigned char>(one) >= 0x20 || one == '\n' || one == '\t' ? one : ' ';
    }
  }
  return safe;
}

std::string in_seconds(double time_s) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", time_s);
  return text.data();
}

std::string case_of(const std::string& suite, const Verdict& verdict) {
  std::string text = "    <testcase classname=\"" + escaped(suite) + "\" name=\"" + escaped(verdict.name) +
                     "\" time=\"" + in_seconds(verdict.took_s) + "\"";
  if (verdict.kind == Verdict::Kind::kGood) return text + "/>\n";
  if (verdict.kind == Verdict::Kind::kSkipped) return text + ">\n      <skipped/>\n    </testcase>\n";
  const std::string headline = verdict.text.substr(0, verdict.text.find('\n'));
  return text + ">\n      <failure message=\"" + escaped(headline) + "\">" + escaped(verdict.text) +
         "</failure>\n    </testcase>\n";
}

}  // namespace

std::string to_junit(const std::string& suite, const std::vector<Verdict>& verdicts) {
  const auto count = [&](Verdict::Kind kind) {
    return std::to_string(std::count_if(verdicts.begin(), verdicts.end(),
                                        [kind](const Verdict& one) { return one.kind == kind; }));
  };
  double took_s = 0.0;
  for (const Verdict& one : verdicts) took_s += one.took_s;
  const std::string counts = "tests=\"" + std::to_string(verdicts.size()) + "\" failures=\"" +
                             count(Verdict::Kind::kFailed) + "\" errors=\"0\" skipped=\"" +
                             count(Verdict::Kind::kSkipped) + "\" time=\"" + in_seconds(took_s) + "\"";
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                     ">\n  <testsuite name=\"" + escaped(suite) + "\" " + counts + ">\n";
  for (const Verdict& one : verdicts) text += case_of(suite, one);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace caravan::deploy
