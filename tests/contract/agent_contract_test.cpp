// SPDX-License-Identifier: Apache-2.0
// The agent contract suite itself: our agents pass it, an agent that breaks a rule fails at that rule, and
// each of the rules P-50 to P-68 has a case, or a reason why it has none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"
#include "tests/system/vendors/snippets.hpp"

namespace caravan::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

const fs::path kTests = fs::path{CARAVAN_BIN_DIR}.parent_path() / "tests";
const fs::path kControllers = fs::path{CARAVAN_BIN_DIR}.parent_path() / "controllers";

class AgentContractSuite : public ::testing::Test {
 protected:
  struct Verdict {
    std::optional<int> exit_code;
    std::string said;
  };
  [[nodiscard]] Verdict judge(const std::vector<std::string>& options) const {
    std::vector<std::string> line{"agent_contract"};
    line.insert(line.end(), options.begin(), options.end());
    Process suite{line, folder_ / "suite.log"};
    Verdict verdict{suite.wait(600s), {}};
    verdict.said = suite.output();
    return verdict;
  }
  static void expect_passed(const Verdict& verdict) {
    EXPECT_EQ(verdict.exit_code, 0) << verdict.said;
    EXPECT_THAT(verdict.said, HasSubstr("[  PASSED  ] "));
  }

  ScratchFolder folder_;
};

TEST_F(AgentContractSuite, IsPassedByThePapersAgent) { expect_passed(judge({})); }

TEST_F(AgentContractSuite, IsPassedByAControllerFromASharedLibrary) {
  expect_passed(judge({"--", "--controller", kControllers / "braitenberg.so"}));
}

TEST_F(AgentContractSuite, IsPassedByAnAgentThatOnlySpeaksTheTopics) {
  const Verdict verdict = judge({"--agent", kTests / "switched_agent"});
  expect_passed(verdict);
  EXPECT_THAT(verdict.said, HasSubstr("it states no role"));
}

/// The agent of docs/other_vendors.md. It does not look at who sends, and has no radio.
TEST_F(AgentContractSuite, IsPassedByAnAgentOfAnotherVendorButForWhoSends) {
  for (const char* needed : {"/usr/bin/idlc", "/usr/include/dds/dds.h", "/usr/bin/cc"})
    if (!fs::exists(needed))
      GTEST_SKIP() << "no " << needed << " here (Debian: cyclonedds-dev, cyclonedds-tools)";
  fs::create_symlink(fs::path{CARAVAN_SOURCE_DIR} / "idl", folder_ / "idl");
  for (const Snippet& snippet : snippets_of(CARAVAN_SOURCE_DIR "/docs/other_vendors.md"))
    if (!snippet.file.empty()) write_file(folder_ / snippet.file, snippet.text);
  for (const char* script : {"contract_agent", "build"})
    fs::permissions(folder_ / script, fs::perms::owner_all);
  PatientProcess build{{"/bin/sh", "-ec", "cd " + folder_.path().string() + " && sh -e ./build"},
                       folder_ / "build.log"};
  ASSERT_EQ(build.wait(kPatience), 0) << build.output();
  const Verdict verdict =
      judge({"--agent", folder_ / "contract_agent", "--transport", "udp", "--gtest_filter=-*P62*"});
  expect_passed(verdict);
  EXPECT_THAT(verdict.said, HasSubstr("the agent does not read rt/robot_1/radio/rx"));
}

struct Fault {
  std::string name;  // as switched_agent knows it
  std::string found_by;
};

class BrokenRule : public AgentContractSuite, public ::testing::WithParamInterface<Fault> {};

TEST_P(BrokenRule, IsFound) {
  const auto& [name, found_by] = GetParam();
  const std::vector<std::string> options{"--agent", kTests / "switched_agent", "--patience", "3",
                                         "--gtest_filter=*" + found_by + "*"};
  std::vector<std::string> broken = options;
  broken.insert(broken.end(), {"--", "--fault", name});
  const Verdict verdict = judge(broken);
  EXPECT_EQ(verdict.exit_code, 1) << verdict.said;
  EXPECT_TRUE(std::regex_search(verdict.said, std::regex{"\\[  FAILED  \\] \\w+\\." + found_by}))
      << verdict.said;
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenRule,
    ::testing::Values(Fault{"no_stamp", "P50"}, Fault{"no_reset", "P51ANewSession"},
                      Fault{"any_session", "P51AFrameOfALowerSession"},
                      Fault{"forgets_radio", "P51KeepsWhatItsRadioSends"}, Fault{"repeats", "P52StepsOnce"},
                      Fault{"other_order", "P52AnswersWith"}, Fault{"says_no_report", "P52AnswersWith"},
                      Fault{"late", "P53"}, Fault{"no_radio", "P54"}, Fault{"no_wait", "P56WaitsASecond"},
                      Fault{"always_waits", "P56AnswersAsSoon"}, Fault{"two_worlds", "P62"},
                      Fault{"not_finite", "P65"}, Fault{"no_gaps", "P52StepsOnce"}, Fault{"busy", "P66"}),
    [](const auto& fault) { return fault.param.name; });

TEST_F(AgentContractSuite, HasACaseForEveryRuleOrTheReasonWhyNot) {
  const Verdict list = judge({"--gtest_list_tests"});
  const std::string page = read_file(CARAVAN_SOURCE_DIR "/docs/agent_contract.md");
  for (int rule = 50; rule <= 68; ++rule) {
    std::smatch row;
    const std::string number = std::to_string(rule);
    ASSERT_TRUE(std::regex_search(page, row, std::regex{"\\n\\| P-" + number + " \\| ([^|]+) \\|"}))
        << "P-" << number << " has no row in docs/agent_contract.md";
    const bool has_case = list.said.find("  P" + number) != std::string::npos;
    const bool has_reason = row[1].str().starts_with("nothing: ");
    EXPECT_NE(has_case, has_reason) << "P-" << number << ": " << row[1];
  }
}

}  // namespace
}  // namespace caravan::test
