// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/system/support/grid.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::kPatience;
using test::Process;
using test::read_file;
using testing::HasSubstr;
using testing::StartsWith;

/// 2 vision radii x 2 fleets x 2 seeds of the small scenario.
std::vector<std::string> small_grid(const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"caravan",
                                    "sweep",
                                    test::scenario("small.toml"),
                                    "--set",
                                    "algorithm.vision_radius_m=2,4",
                                    "--set",
                                    "robots.count=2,4",
                                    "--seeds",
                                    "1-2",
                                    "--jobs",
                                    "2",
                                    "--items",
                                    "0",
                                    "--max-time",
                                    "150"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Grid, SurvivesKillsWithoutLosingOrRepeatingARun) { test::expect_to_survive_kills(small_grid(), 4, 1); }

TEST(Grid, ItsRunsAreThoseOfCaravanRunWithTheSameSettings) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  Process sweep{small_grid({"--out", out}), folder / "sweep.log"};
  ASSERT_EQ(sweep.wait(kPatience), 0) << sweep.output();
  Process run{{"caravan", "run", test::scenario("small.toml"), "--engine", "embedded", "--seed", "2",
               "--items", "0", "--max-time", "150", "--set", "robots.count=2", "--set",
               "algorithm.vision_radius_m=4.0", "--quiet", "--out", folder / "run"},
              folder / "run.log"};
  ASSERT_EQ(run.wait(kPatience), 0) << run.output();

  const std::string metrics = read_file(folder / "run/metrics.json");
  const std::size_t place = metrics.find("\"digest\"");
  const std::string digest = metrics.substr(metrics.find_first_of("0123456789abcdef", place + 9), 16);
  EXPECT_THAT(read_file(out / "runs.csv"), HasSubstr("\n5,full,2,4,2,done,," + digest + ","));
  EXPECT_THAT(sweep.output(), HasSubstr("algorithm.vision_radius_m=4,robots.count=2 full seed 2: done"));
}

class BadGrid : public testing::Test {
 protected:
  /// One line, exit code 2. @return the line
  std::string refusal(std::vector<std::string> words) {
    Process process{std::move(words), folder_ / "refused.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    std::string said = process.output();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    return said;
  }
  std::string refusal_of(const std::string& set) {
    const fs::path out = folder_ / "new";
    std::string said =
        refusal({"caravan", "sweep", test::scenario("small.toml"), "--set", set, "--out", out});
    EXPECT_FALSE(fs::exists(out));
    return said;
  }

  test::ScratchFolder folder_;
};

TEST_F(BadGrid, IsRefusedBeforeAnythingIsWritten) {
  EXPECT_THAT(refusal_of("algorithm.vision=2,4"), StartsWith("--set algorithm.vision=2: unknown key"));
  EXPECT_THAT(refusal_of("algorithm.vision_radius_m="),
              StartsWith("--set algorithm.vision_radius_m=: has no value"));
  EXPECT_THAT(refusal_of("algorithm.vision_radius_m=2,-1"),
              StartsWith("--set algorithm.vision_radius_m=-1: must be"));
  EXPECT_THAT(refusal_of("robots.count=two"), StartsWith("--set robots.count=two: must be a whole number"));
}

TEST_F(BadGrid, TheFolderOfAnotherSweepIsLeftAsItIs) {
  const fs::path out = folder_ / "out";
  std::vector<std::string> words = {"caravan", "sweep",   test::scenario("small.toml"),
                                    "--items", "0",       "--max-time",
                                    "20",      "--seeds", "1",
                                    "--quiet", "--out",   out,
                                    "--set"};
  const auto with = [&words](const std::string& set) {
    std::vector<std::string> all = words;
    all.push_back(set);
    return all;
  };
  Process first{with("robots.count=2,4"), folder_ / "first.log"};
  ASSERT_EQ(first.wait(kPatience), 0) << first.output();
  const std::string tables = read_file(out / "runs.csv") + read_file(out / "sweep.json");

  EXPECT_THAT(refusal(with("robots.count=2")), HasSubstr("robots.count=4 full 1 is not among these runs"));
  EXPECT_THAT(refusal(with("algorithm.vision_radius_m=2,4")), HasSubstr("is not among these runs"));
  EXPECT_EQ(read_file(out / "runs.csv") + read_file(out / "sweep.json"), tables);
  Process more{with("robots.count=2,4,3"), folder_ / "more.log"};
  EXPECT_EQ(more.wait(kPatience), 0) << more.output();
}

TEST_F(BadGrid, CheckRunAndDeployRefuseASettingByName) {
  const std::string small = test::scenario("small.toml");
  const std::string line = "--set algorithm.vision_radius_m=-1: must be";
  const std::string set = "algorithm.vision_radius_m=-1";
  EXPECT_THAT(refusal({"caravan", "check", small, "--set", set}), StartsWith(line));
  EXPECT_THAT(refusal({"caravan", "run", small, "--set", set, "--out", folder_ / "run"}), StartsWith(line));
  EXPECT_FALSE(fs::exists(folder_ / "run"));
  const fs::path script = folder_ / "script.toml";
  test::write_file(script, "scenario = \"" + small + "\"\n[[step]]\ndo = \"start all; go\"\n");
  EXPECT_THAT(refusal({"caravan", "deploy", script, "--set", set, "--out", folder_ / "logs"}),
              StartsWith(line));
  EXPECT_FALSE(fs::exists(folder_ / "logs"));
}

}  // namespace
}  // namespace caravan
