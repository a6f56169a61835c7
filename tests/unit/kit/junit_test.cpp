// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/junit.hpp"

#include <gtest/gtest.h>

namespace caravan::deploy {
namespace {

TEST(Junit, CountsAndEscapes) {
  using Kind = Verdict::Kind;
  const std::string report = to_junit("a \"suite\"", {{"good", Kind::kGood, "", 1.5},
                                                      {"bad", Kind::kFailed, "a < b\nmore & more", 2.0},
                                                      {"not reached", Kind::kSkipped, "", 0.0}});
  EXPECT_EQ(report,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" time=\"3.500\">\n"
            "  <testsuite name=\"a &quot;suite&quot;\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" "
            "time=\"3.500\">\n"
            "    <testcase classname=\"a &quot;suite&quot;\" name=\"good\" time=\"1.500\"/>\n"
            "    <testcase classname=\"a &quot;suite&quot;\" name=\"bad\" time=\"2.000\">\n"
            "      <failure message=\"a &lt; b\">a &lt; b\nmore &amp; more</failure>\n"
            "    </testcase>\n"
            "    <testcase classname=\"a &quot;suite&quot;\" name=\"not reached\" time=\"0.000\">\n"
            "      <skipped/>\n"
            "    </testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

}  // namespace
}  // namespace caravan::deploy
