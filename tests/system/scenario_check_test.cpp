// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::Process;

const fs::path kSmall = test::scenario("small.toml");

class BadScenario : public testing::Test {
 protected:
  struct Ended {
    std::optional<int> exit_code;
    std::string said;
  };
  Ended end_of(std::vector<std::string> words) {
    words.insert(words.begin(), "caravan");
    Process process{words, folder_ / "log"};
    const auto code = process.wait(std::chrono::seconds{30});
    return {code, process.output()};
  }
  /// Expects a run to be refused with exit code 2 and one line, before it creates any file. @return the line
  std::string refusal(const std::string& scenario, const std::vector<std::string>& more = {}) {
    const fs::path out = folder_ / "out";
    std::vector<std::string> words = {"run", scenario, "--engine", "embedded", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = end_of(words);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(std::count(ended.said.begin(), ended.said.end(), '\n'), 1) << ended.said;
    EXPECT_FALSE(fs::exists(out));
    return ended.said;
  }
  /// Expects the small scenario with one text replaced to be refused with `complaint` at that line.
  void expect_refused(const std::string& right, const std::string& wrong, const std::string& complaint) {
    std::string text = test::read_file(kSmall);
    const std::size_t place = text.find(right);
    ASSERT_NE(place, std::string::npos) << right;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    std::ofstream{scenario_} << text.replace(place, right.size(), wrong);
    EXPECT_THAT(refusal(scenario_),
                testing::StartsWith(scenario_.string() + ":" + std::to_string(line) + ": " + complaint));
  }

  test::ScratchFolder folder_;
  fs::path scenario_ = folder_ / "bad.toml";
};

TEST(CheckConfig, SaysThatTheScenarioIsGoodAndStartsNothing) {
  const test::ScratchFolder folder;
  const std::vector<std::vector<std::string>> programs = {
      {"world_server"}, {"radio_emulator"}, {"robot_agent", "--robots", "1-4"}};
  for (std::vector<std::string> words : programs) {
    words.insert(words.end(), {"--check-config", "--scenario", kSmall});
    Process process{words, folder / "log"};
    EXPECT_EQ(process.wait(test::kPatience), 0);
    EXPECT_EQ(process.output(), kSmall.string() + ": good\n");
    words.back() = folder / "bad.toml";
    test::write_file(words.back(), "[robots]\ncolour = 3\n");
    Process refused{words, folder / "log"};
    EXPECT_EQ(refused.wait(test::kPatience), 2);
    EXPECT_THAT(refused.output(), testing::Not(testing::HasSubstr("good")));
  }
}

TEST_F(BadScenario, AMissingFileIsNamed) {
  EXPECT_THAT(refusal("nowhere.toml"), testing::HasSubstr("nowhere.toml: no such"));
}

TEST_F(BadScenario, EveryTableIsCheckedAndTheLineAndKeyAreNamed) {
  expect_refused("seed = 1", "colour = 3", "colour: unknown key");
  expect_refused("seed = 1", "seed = \"one\"", "seed: must be");
  expect_refused("count = 4", "count = 4.5", "robots.count: must be a whole number");
  expect_refused("range_m = 2.0", "range_m = -2.0",
                 "radio.range_m: must be above 0 and at most 1e+06, is -2");
  expect_refused("mode = \"full\"", "mode = \"loud\"", "algorithm.mode: must be one of");
  expect_refused("arena_m = ", "areena_m = ", "world.areena_m: unknown key");
  expect_refused("max_time_s = 3600.0", "max_time_s = nan", "experiment.max_time_s: must be finite");
  expect_refused("items = 4", "items = = 4", "");
}

TEST_F(BadScenario, AWrongChangeOnTheCommandLineIsRefusedLikeAWrongFile) {
  EXPECT_THAT(refusal(kSmall, {"--robots", "0"}), testing::HasSubstr("robots.count: "));
  EXPECT_THAT(refusal(kSmall, {"--max-time", "-5"}), testing::HasSubstr("experiment.max_time_s: "));
  EXPECT_THAT(refusal(kSmall, {"--mode", "loud"}), testing::HasSubstr("--mode"));
}

TEST_F(BadScenario, MoreRobotsThanTheArenaHoldsAreRefused) {
  EXPECT_THAT(refusal(kSmall, {"--robots", "5000"}), testing::HasSubstr("robots.count: "));
}

TEST_F(BadScenario, AKeyWithControlCharactersStaysOnOneLine) {
  test::write_file(scenario_, "\"\\u001b[2J\\nfoo\" = 1\n");
  EXPECT_THAT(refusal(scenario_), testing::HasSubstr(":1: \\x1b[2J\\nfoo: unknown key"));
}

TEST_F(BadScenario, AFolderThatHoldsSomethingIsLeftAlone) {
  const Ended ended = end_of({"run", kSmall, "--engine", "embedded", "--out", kSmall.parent_path()});

  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.said, testing::HasSubstr("is not empty"));
}

TEST_F(BadScenario, CheckSaysTheSameAsARunAndRunsNothing) {
  std::ofstream{scenario_} << "[radio]\nrange_m = -2.0\n";

  EXPECT_EQ(end_of({"check", scenario_}).said, refusal(scenario_));
  EXPECT_EQ(end_of({"check", kSmall}).exit_code, 0);
}

TEST_F(BadScenario, EveryScenarioOfTheProjectIsGood) {
  for (const auto& entry : fs::directory_iterator{kSmall.parent_path()}) {
    if (entry.path().extension() != ".toml") continue;
    const Ended ended = end_of({"check", entry.path()});
    EXPECT_EQ(ended.exit_code, 0) << ended.said;
  }
}

}  // namespace
}  // namespace caravan
